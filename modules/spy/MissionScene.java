package citrine_spy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

import citrine_lcm.clock_t;
import citrine_lcm.fleet_status_t;
import citrine_lcm.map_summary_t;
import citrine_lcm.mission_progress_t;
import citrine_lcm.octree_t;
import citrine_lcm.trajectory_t;
import citrine_lcm.uav_state_t;
import lcm.lcm.LCM;
import lcm.lcm.LCMDataInputStream;
import lcm.lcm.LCMSubscriber;

/** What has been heard of a mission, as far as a top-down picture shows it. */
final class MissionScene implements LCMSubscriber {
  /** One UAV. */
  static final class Uav {
    uav_state_t state;
    fleet_status_t status;
    trajectory_t trajectory;
    final List<double[]> trail = new ArrayList<>();  // x, y in the world frame [m]
  }

  private static final double TRAIL_STEP_M = 0.1;

  final Map<Integer, Uav> uavs = new TreeMap<>();
  clock_t clock;
  mission_progress_t progress;
  map_summary_t summary;
  double cell_m = 0.25;
  Map<OctreeHeights.Cell, Integer> heights = Map.of();
  private final OctreeHeights octree = new OctreeHeights();

  MissionScene(LCM lcm) {
    lcm.subscribe("CLOCK|MISSION_PROGRESS|MAP_SUMMARY|MAP_OCTREE|UAV[0-9]+_(STATE|FLEET_STATUS|TRAJECTORY)", this);
  }

  @Override
  public synchronized void messageReceived(LCM lcm, String channel, LCMDataInputStream in) {
    try {
      switch (channel) {
        case "CLOCK" -> clock = new clock_t(in);
        case "MISSION_PROGRESS" -> progress = new mission_progress_t(in);
        case "MAP_SUMMARY" -> summary = new map_summary_t(in);
        case "MAP_OCTREE" -> hear(new octree_t(in));
        default -> hearUav(channel, in);
      }
    } catch (IOException | NegativeArraySizeException notOurs) {
      // lcm-spy itself counts it as undecodable
    }
  }

  private void hear(octree_t message) {
    Map<OctreeHeights.Cell, Integer> whole = octree.add(message);
    if (whole == null) return;
    heights = whole;
    cell_m = message.resolution_m;
  }

  private void hearUav(String channel, LCMDataInputStream in) throws IOException {
    int end = channel.indexOf('_');
    Uav uav = uavs.computeIfAbsent(Integer.parseInt(channel.substring(3, end)), id -> new Uav());
    switch (channel.substring(end + 1)) {
      case "STATE" -> hear(uav, new uav_state_t(in));
      case "FLEET_STATUS" -> uav.status = new fleet_status_t(in);
      default -> uav.trajectory = new trajectory_t(in);
    }
  }

  private static void hear(Uav uav, uav_state_t state) {
    uav.state = state;
    double[] here = {state.p_WB[0], state.p_WB[1]};
    double[] last = uav.trail.isEmpty() ? null : uav.trail.get(uav.trail.size() - 1);
    if (last == null || Math.hypot(here[0] - last[0], here[1] - last[1]) > TRAIL_STEP_M) uav.trail.add(here);
  }
}
