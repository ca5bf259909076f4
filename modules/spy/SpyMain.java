package citrine_spy;

import java.awt.Frame;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.io.File;
import java.lang.reflect.Field;
import java.util.List;
import javax.imageio.ImageIO;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;

import lcm.spy.ChannelData;
import lcm.spy.Spy;

/**
 * lcm-spy with the mission from above beside it. With the arguments SECONDS FILE.png it ends after that time, having
 * saved the screen, and says of every channel whether it decoded.
 */
public final class SpyMain {
  private static final int GAP_PX = 8;

  public static void main(String[] arguments) throws Exception {
    Spy spy = new Spy(System.getenv("LCM_DEFAULT_URL"));
    SwingUtilities.invokeAndWait(() -> {
      JFrame mission = MissionPlugin.open();
      for (Frame frame : Frame.getFrames())
        if (frame != mission && frame.isVisible()) mission.setLocation(frame.getX() + frame.getWidth() + GAP_PX, frame.getY());
    });
    if (arguments.length < 2) return;
    Thread.sleep((long) (1000 * Double.parseDouble(arguments[0])));
    Rectangle screen = new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
    ImageIO.write(new Robot().createScreenCapture(screen), "png", new File(arguments[1]));
    System.exit(sayChannels(spy) ? 0 : 3);
  }

  /** @return whether every message of every channel decoded */
  private static boolean sayChannels(Spy spy) throws ReflectiveOperationException {
    Field list = Spy.class.getDeclaredField("channelList");
    list.setAccessible(true);
    boolean all = true;
    for (Object entry : List.copyOf((List<?>) list.get(spy))) {
      ChannelData channel = (ChannelData) entry;
      boolean ours = channel.cls != null && channel.nerrors == 0;
      if (channel.name.equals("LCM_SELF_TEST") || channel.name.equals("BUS_PROBE")) continue;
      System.out.printf("%-22s %-20s %6d messages%s%n", channel.name, channel.cls == null ? "?" : channel.cls.getSimpleName(),
          channel.nreceived, ours ? "" : ", of which " + channel.nerrors + " do not decode");
      all &= ours;
    }
    return all;
  }
}
