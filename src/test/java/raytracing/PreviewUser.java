package raytracing;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Point;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Scanner;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;

/**
 * Runs the program in a virtual machine with somebody who uses its window: does what standard input says, line by line, and
 * answers on standard output.
 */
final class PreviewUser {
    private PreviewUser() {
    }

    public static void main(String[] arguments) {
        Thread user = new Thread(PreviewUser::obey);
        user.setDaemon(true);
        user.start();
        RayTracer.main(arguments);
    }

    private static void obey() {
        try (BufferedReader orders = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8))) {
            JFrame frame = awaitFrame();
            Robot robot = new Robot();
            for (String order = orders.readLine(); order != null; order = orders.readLine()) {
                obey(new Scanner(order), frame, robot);
                System.out.println("done");
            }
        } catch (IOException | AWTException | ReflectiveOperationException | InterruptedException failure) {
            failure.printStackTrace();
        }
    }

    private static JFrame awaitFrame() throws InterruptedException {
        while (true) {
            for (Window window : Window.getWindows()) {
                if (window instanceof JFrame frame && frame.isShowing()) {
                    return frame;
                }
            }
            Thread.sleep(20);
        }
    }

    private static void obey(Scanner order, JFrame frame, Robot robot)
            throws ReflectiveOperationException, InterruptedException {
        switch (order.next()) {
            case "title" -> System.out.println(frame.getTitle());
            case "view" -> SwingUtilities.invokeAndWait(() -> {
                Component view = frame.getContentPane().getComponent(0);
                Point corner = view.getLocationOnScreen();
                System.out.println(corner.x + " " + corner.y + " " + view.getWidth() + " " + view.getHeight());
            });
            case "point" -> robot.mouseMove(order.nextInt(), order.nextInt());
            case "wheel" -> robot.mouseWheel(order.nextInt());
            case "grip" -> robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            case "release" -> robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
            case "escape" -> type(robot, KeyEvent.VK_ESCAPE);
            case "type" -> type(robot, KeyEvent.getExtendedKeyCodeForChar(order.next().charAt(0)));
            case "close" -> Toolkit.getDefaultToolkit().getSystemEventQueue().postEvent(
                new WindowEvent(frame, WindowEvent.WINDOW_CLOSING));
            default -> throw new IllegalArgumentException("unknown order");
        }
    }

    private static void type(Robot robot, int key) {
        robot.keyPress(key);
        robot.keyRelease(key);
    }
}
