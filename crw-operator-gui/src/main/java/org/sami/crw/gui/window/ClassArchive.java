package org.sami.crw.gui.window;

import static java.util.concurrent.TimeUnit.SECONDS;

import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.gui.context.BoatSelection;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.start.OperatorCommand;
import org.sami.crw.gui.start.SessionOpener;
import org.sami.crw.gui.status.FleetStopCommands;
import org.sami.crw.gui.status.StatusStrip;
import org.sami.crw.session.Session;
import org.sami.palette.ProxyMarks;
import org.sami.palette.Theme;
import org.sami.ui.EventThread;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.look.Look;
import org.sami.ui.window.Notices;
import org.sami.ui.window.WindowSettings;
import picocli.CommandLine;

/**
 * Loads what the window needs, without a display, so that the Java that runs this can keep its classes in an archive from which the program starts
 * faster. The start script calls it when the program is installed.
 */
final class ClassArchive {
    private static final int WIDTH = 1000;
    private static final int HEIGHT = 700;
    private static final int REPORTS = 20; // some of each of the five boats
    private static final int PATIENCE_S = 20;

    private ClassArchive() {}

    /** Opens a session with the built-in fleet, starts a mission that asks for something, makes every panel over it and paints it into memory. */
    public static void main(String[] args) throws Exception {
        new CommandLine(new OperatorCommand((options, data) -> {})).execute("--version");
        boolean whole = false;
        Path folder = Files.createTempDirectory("crw-operator-classes");
        try (DataDirectory data = DataDirectory.open(folder)) {
            WindowSettings settings = new WindowSettings(data.settings());
            try (Session session = new SessionOpener(data, List.of(), Optional.empty()).openNew()) {
                CountDownLatch asked = new CountDownLatch(1);
                CountDownLatch reported = new CountDownLatch(REPORTS);
                session.models().decisions().addListener(waiting -> {
                    if (!waiting.isEmpty()) {
                        asked.countDown();
                    }
                });
                session.subscribe(Runnable::run, event -> {
                    if (event instanceof FleetEvent.StatusReported) {
                        reported.countDown();
                    }
                });
                session.begin();
                session.start(SessionOpener.OFFERED_PLAN, "", Map.of());
                whole = asked.await(PATIENCE_S, SECONDS) && reported.await(PATIENCE_S, SECONDS);
                EventThread.get(() -> {
                    paint(session, settings);
                    return null;
                });
            }
        } finally {
            delete(folder);
        }
        System.exit(whole ? 0 : 1);
    }

    private static void paint(Session session, WindowSettings settings) {
        Look.apply(Theme.LIGHT, 100);
        OperatorContext context = new OperatorContext(
                session, new CommandRegistry(), new ProxyMarks(), new BoatSelection(), new Notices());
        FleetStopCommands fleetStop = new FleetStopCommands(context);
        try (OperatorPanels panels = new OperatorPanels(context, settings, new LoadedProject(Optional.empty()))) {
            for (DockPanel panel : panels.all()) {
                paint(panel);
            }
            panels.refresh();
            Command any = context.commands().all().iterator().next();
            paint(new StatusStrip(context, fleetStop, any, any, panels::decisionUnseen));
            new WindowMenus(context.commands(), panels.all(), RobotKind.BOAT).bar();
        }
    }

    private static void paint(Container part) {
        part.setSize(WIDTH, HEIGHT);
        part.doLayout();
        Graphics2D g = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB).createGraphics();
        part.paint(g);
        g.dispose();
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }
}
