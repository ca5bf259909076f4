package citrine_spy;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Map;
import javax.swing.JPanel;
import javax.swing.Timer;

import citrine_lcm.map_summary_t;
import citrine_lcm.trajectory_t;

/** The mission from above: the map by height, each UAV with its trail, its trajectory ahead and its goal. */
final class MissionPanel extends JPanel {
  // Okabe and Ito's colours, told apart by colour-blind eyes, too.
  private static final Color[] UAV_COLOURS = {new Color(0xD55E00), new Color(0x0072B2), new Color(0x009E73),
      new Color(0xCC79A7), new Color(0xE69F00), new Color(0x56B4E9)};
  private static final Color PAPER = new Color(0xF4F4F2), INK = new Color(0x222222);
  private static final Color LOW = new Color(0xD9D4C7), HIGH = new Color(0x54453B);
  private static final int HEADER_PX = 44, MARGIN_PX = 14, REDRAW_MS = 100;
  private static final double UAV_M = 0.45, SAMPLE_S = 0.1;

  private final MissionScene scene;
  private double scale, left_px, bottom_px;  // of the world's origin, and pixels a metre

  MissionPanel(MissionScene scene) {
    this.scene = scene;
    setPreferredSize(new Dimension(720, 700));
    setBackground(PAPER);
    new Timer(REDRAW_MS, tick -> repaint()).start();
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    super.paintComponent(graphics);
    Graphics2D g = (Graphics2D) graphics;
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    synchronized (scene) {
      paintHeader(g);
      if (scene.summary == null) return;
      fit(scene.summary);
      paintMap(g);
      for (Map.Entry<Integer, MissionScene.Uav> uav : scene.uavs.entrySet())
        paintUav(g, uav.getKey(), uav.getValue());
      paintScale(g);
    }
  }

  private void paintHeader(Graphics2D g) {
    g.setColor(INK);
    g.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 15));
    if (scene.clock == null) {
      g.drawString("nothing is said on CLOCK yet", MARGIN_PX, 20);
      return;
    }
    long seconds = scene.clock.utime / 1_000_000;
    g.drawString(String.format("%s   t %02d:%02d", scene.clock.mission_id, seconds / 60, seconds % 60), MARGIN_PX, 20);
    g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
    if (scene.progress == null) return;
    double atGoal_pct = 100.0 * scene.progress.voxels_at_goal / Math.max(scene.progress.surface_voxels, 1);
    g.drawString(String.format("at goal %.1f %%   known %.1f %%   active elements %d", atGoal_pct,
        scene.progress.known_pct, scene.progress.elements_ise + scene.progress.elements_lqse), MARGIN_PX, 38);
  }

  /** The whole mission volume, as large as it goes. */
  private void fit(map_summary_t summary) {
    double width_m = summary.volume_max_W[0] - summary.volume_min_W[0];
    double depth_m = summary.volume_max_W[1] - summary.volume_min_W[1];
    double width_px = getWidth() - 2.0 * MARGIN_PX, depth_px = getHeight() - 2.0 * MARGIN_PX - HEADER_PX;
    scale = Math.min(width_px / width_m, depth_px / depth_m);
    left_px = MARGIN_PX + (width_px - scale * width_m) / 2 - scale * summary.volume_min_W[0];
    bottom_px = getHeight() - MARGIN_PX - (depth_px - scale * depth_m) / 2 + scale * summary.volume_min_W[1];
  }

  private double x(double x_W) {
    return left_px + scale * x_W;
  }

  private double y(double y_W) {
    return bottom_px - scale * y_W;
  }

  private void paintMap(Graphics2D g) {
    double cell_m = scene.cell_m, top_m = Math.max(scene.summary.volume_max_W[2], cell_m);
    map_summary_t s = scene.summary;
    Rectangle2D volume = new Rectangle2D.Double(x(s.volume_min_W[0]), y(s.volume_max_W[1]),
        scale * (s.volume_max_W[0] - s.volume_min_W[0]), scale * (s.volume_max_W[1] - s.volume_min_W[1]));
    g.clip(volume);
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);  // no seams
    for (Map.Entry<OctreeHeights.Cell, Integer> cell : scene.heights.entrySet()) {
      g.setColor(between(LOW, HIGH, Math.min(1, Math.sqrt(Math.max(0, cell.getValue() * cell_m / top_m)))));
      g.fill(new Rectangle2D.Double(x(cell.getKey().x() * cell_m), y((cell.getKey().y() + 1) * cell_m),
          scale * cell_m + 0.5, scale * cell_m + 0.5));
    }
    g.setClip(null);
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setColor(INK);
    g.draw(volume);
  }

  private static Color between(Color a, Color b, double share) {
    return new Color((int) (a.getRed() + share * (b.getRed() - a.getRed())),
        (int) (a.getGreen() + share * (b.getGreen() - a.getGreen())),
        (int) (a.getBlue() + share * (b.getBlue() - a.getBlue())));
  }

  private void paintUav(Graphics2D g, int id, MissionScene.Uav uav) {
    if (uav.state == null) return;
    g.setColor(UAV_COLOURS[(id - 1) % UAV_COLOURS.length]);
    g.setStroke(new BasicStroke(1.2f));
    Path2D trail = new Path2D.Double();
    for (double[] p_W : uav.trail) lineTo(trail, p_W[0], p_W[1]);
    g.draw(trail);
    double[] p_W = uav.state.p_WB;
    if (uav.trajectory != null) {
      g.setStroke(new BasicStroke(3f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
      g.draw(ahead(uav.trajectory));
    }
    if (uav.status != null && uav.status.has_goal) {
      double gx = x(uav.status.goal_W[0]), gy = y(uav.status.goal_W[1]);
      g.setStroke(new BasicStroke(2f));
      g.draw(new Ellipse2D.Double(gx - 6, gy - 6, 12, 12));
    }
    double radius = Math.max(8, scale * UAV_M);
    g.fill(new Ellipse2D.Double(x(p_W[0]) - radius, y(p_W[1]) - radius, 2 * radius, 2 * radius));
    g.setColor(Color.WHITE);
    g.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 12));
    g.drawString(Integer.toString(id), (float) x(p_W[0]) - 4, (float) y(p_W[1]) + 5);
  }

  private void lineTo(Path2D path, double x_W, double y_W) {
    if (path.getCurrentPoint() == null) path.moveTo(x(x_W), y(y_W));
    path.lineTo(x(x_W), y(y_W));
  }

  /** What is left of a trajectory: quintics in seconds since each segment began. */
  private Path2D ahead(trajectory_t trajectory) {
    Path2D path = new Path2D.Double();
    double now_s = scene.clock == null ? 0 : (scene.clock.utime - trajectory.start_utime) * 1e-6, begun_s = 0;
    for (int i = 0; i < trajectory.num_segments; i++) {
      for (double s = 0; s <= trajectory.duration_s[i]; s += SAMPLE_S)
        if (begun_s + s >= now_s) lineTo(path, at(trajectory.x_W, i, s), at(trajectory.y_W, i, s));
      begun_s += trajectory.duration_s[i];
    }
    return path;
  }

  private static double at(double[] coefficients, int segment, double s) {
    double value = 0;
    for (int k = 5; k >= 0; k--) value = value * s + coefficients[6 * segment + k];
    return value;
  }

  private void paintScale(Graphics2D g) {
    double length_m = scale * 5 < getWidth() / 3.0 ? 5 : 1;
    double right_px = getWidth() - MARGIN_PX, y_px = 22;
    g.setColor(INK);
    g.setStroke(new BasicStroke(3f));
    g.draw(new java.awt.geom.Line2D.Double(right_px - scale * length_m, y_px, right_px, y_px));
    g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
    g.drawString(String.format("%.0f m", length_m), (float) (right_px - scale * length_m), 38f);
  }
}
