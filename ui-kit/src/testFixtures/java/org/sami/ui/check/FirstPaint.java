package org.sami.ui.check;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Toolkit;
import java.awt.event.PaintEvent;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.ui.EventThread;

/** Runs a program until its window was painted, and prints how many ms that took from the start of this process, which ends there. */
public final class FirstPaint {
    private FirstPaint() {}

    /**
     * Runs it.
     *
     * @param args name of the window, class of the program, and what the program takes
     */
    public static void main(String[] args) throws Exception {
        String window = args[0];
        AtomicBoolean seen = new AtomicBoolean();
        Toolkit.getDefaultToolkit()
                .addAWTEventListener(
                        event -> {
                            if (event instanceof PaintEvent
                                    && event.getSource() instanceof Component component
                                    && window.equals(component.getName())
                                    && seen.compareAndSet(false, true)) {
                                EventThread.later(FirstPaint::painted); // behind the painting
                            }
                        },
                        AWTEvent.PAINT_EVENT_MASK);
        String[] own = Arrays.copyOfRange(args, 2, args.length);
        Class.forName(args[1]).getMethod("main", String[].class).invoke(null, (Object) own);
    }

    private static void painted() {
        System.out.println(System.currentTimeMillis()
                - ManagementFactory.getRuntimeMXBean().getStartTime());
        Runtime.getRuntime().halt(0);
    }
}
