package citrine_spy;

import java.awt.event.ActionEvent;
import java.util.Set;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JDesktopPane;
import javax.swing.JFrame;

import citrine_lcm.clock_t;
import citrine_lcm.fleet_status_t;
import citrine_lcm.map_summary_t;
import citrine_lcm.mission_progress_t;
import citrine_lcm.octree_t;
import citrine_lcm.uav_state_t;
import lcm.lcm.LCM;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;

/** Adds "Mission from above" to the menu of those channels of lcm-spy that the picture shows. */
public final class MissionPlugin implements SpyPlugin {
  private static final Set<Long> SHOWN = Set.of(clock_t.LCM_FINGERPRINT, fleet_status_t.LCM_FINGERPRINT,
      map_summary_t.LCM_FINGERPRINT, mission_progress_t.LCM_FINGERPRINT, octree_t.LCM_FINGERPRINT,
      uav_state_t.LCM_FINGERPRINT);

  @Override
  public boolean canHandle(long fingerprint) {
    return SHOWN.contains(fingerprint);
  }

  @Override
  public Action getAction(JDesktopPane desktop, ChannelData channel) {
    return new AbstractAction("Mission from above") {
      @Override
      public void actionPerformed(ActionEvent event) {
        open();
      }
    };
  }

  /** Opens the picture in a window of its own. */
  static JFrame open() {
    JFrame frame = new JFrame("Mission from above");
    frame.add(new MissionPanel(new MissionScene(LCM.getSingleton())));
    frame.pack();
    frame.setVisible(true);
    return frame;
  }
}
