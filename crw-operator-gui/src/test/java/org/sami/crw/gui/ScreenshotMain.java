package org.sami.crw.gui;

import java.awt.Rectangle;
import java.awt.Robot;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import javax.imageio.ImageIO;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.DefaultAnswers;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.session.Session;
import org.sami.crw.sim.run.operator.SimulatedOperatorDriver;
import org.sami.palette.Theme;
import org.sami.spn.testing.TemporaryFolder;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.look.Look;

/**
 * Opens the window over five simulated boats, runs missions in it with a simulated operator, and makes a picture of each scene in each
 * theme: what the README and the operator's guide show.
 */
final class ScreenshotMain {
    private static final GeoPoint CENTRE = GeoPoint.of(25.3597, 51.5290);
    private static final List<String> NAMES = List.of("anna", "bert", "carl", "dora", "emil");

    private final Path pictures;
    private final WindowRobot robot = new WindowRobot();
    private OperatorWindow window;

    private ScreenshotMain(Path pictures) {
        this.pictures = pictures;
    }

    /**
     * Makes the pictures.
     *
     * @param args the folder that they go to
     */
    public static void main(String[] args) throws Exception {
        ScreenshotMain pictures = new ScreenshotMain(Path.of(args[0]));
        try (TemporaryFolder data = new TemporaryFolder("crw-pictures")) {
            pictures.run(data.path());
        }
        arrangement(args[0], "uav", "look,search?", "operator-copters");
        arrangement(args[0], "crw", "explore-team", "operator-aims");
        arrangement(args[0], "team", "scout-and-sample", "operator-team");
        System.exit(0);
    }

    /** A process has one window, so each of these has a process of its own. */
    private static void arrangement(String folder, String domain, String plans, String name) throws Exception {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        int code = new ProcessBuilder(
                        java,
                        "-cp",
                        System.getProperty("java.class.path"),
                        ArrangementScenes.class.getName(),
                        folder,
                        domain,
                        plans,
                        name,
                        "100")
                .inheritIO()
                .start()
                .waitFor();
        if (code != 0) {
            throw new IllegalStateException("the pictures of " + name + " end with " + code);
        }
    }

    private void run(Path data) throws Exception {
        LoopbackFleet boats = new LoopbackFleet(NAMES);
        OpenedWindow opened = OpenedWindow.over(boats.addresses(), data);
        window = opened.window();
        robot.untilSaid("boats-count", "5 of 5");
        robot.clickRow("plans-table", "Connect Boat");
        robot.click("mission-start");
        robot.untilSaid("decisions-count", "1 decision");
        picture("connect");
        session().abortAll();
        robot.until(
                "no mission runs",
                () -> session().models().missions().snapshot().running().isEmpty());
        robot.click("mission-close");

        TroubleScenes trouble = new TroubleScenes(window, data, this::trouble);
        trouble.judgedAnswer();
        trouble.stuck("bert");

        answer();
        session().start("deploy-and-station-keep", "station", Map.of());
        robot.until("boats keep station", () -> moving() >= 3);
        pass(25);
        picture("station-keep");
        session().abortAll();
        robot.until(
                "no mission runs",
                () -> session().models().missions().snapshot().running().isEmpty());
        robot.click("mission-close");

        session().start("explore-team", "explore", Map.of());
        robot.until("all explore", () -> moving() == NAMES.size());
        pass(40);
        picture("explore");
        robot.clickRow("boats-table", "bert");
        robot.click("interrupt-battery-swap");
        pass(6); // bert is on its way home, the others explore
        picture("interrupt");
        boats.end("emil");
        robot.until("emil is lost", () -> boat("emil").link() == LinkState.LOST);
        pass(3);
        picture("loss-of-communication");
        trouble.links();
        trouble.fleetStop();
        trouble.journal();
        opened.end();
    }

    private void answer() {
        DefaultAnswers defaults = new DefaultAnswers(LoopbackFleet.QUAY, CENTRE, 150, 6, 1, NAMES);
        SimulatedOperatorDriver driver = new SimulatedOperatorDriver(
                new SimulatedOperator(session().setup().vocabulary(), defaults, AnswersFile.EMPTY),
                session().scheduler(),
                800,
                LoopbackFleet.QUAY);
        session().execute(() -> {
            session().addOperator(driver);
            driver.connect(session());
        });
    }

    private Session session() {
        return window.session();
    }

    private BoatSnapshot boat(String name) {
        return session().models().fleet().boat(name).orElseThrow();
    }

    private long moving() {
        return session().models().fleet().snapshot().stream()
                .filter(boat -> boat.command().isPresent())
                .count();
    }

    private static void pass(int seconds) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
        while (System.nanoTime() < end) {
            LockSupport.parkNanos(end - System.nanoTime());
        }
    }

    /** What the guide shows next to its words on trouble. */
    private void trouble(String scene) throws Exception {
        picture("trouble-" + scene, List.of(Theme.LIGHT));
    }

    private void picture(String scene) throws Exception {
        picture(scene, List.of(Theme.values()));
    }

    private void picture(String scene, List<Theme> themes) throws Exception {
        for (Theme theme : themes) {
            WindowRobot.ask(() -> {
                Look.apply(theme, 100);
                return null;
            });
            pass(1);
            Rectangle bounds = WindowRobot.ask(() -> new Rectangle(
                    window.frame().getRootPane().getLocationOnScreen(),
                    window.frame().getRootPane().getSize()));
            Path file = pictures.resolve("operator-" + scene + (theme == Theme.LIGHT ? "" : "-" + theme.id()) + ".png");
            ImageIO.write(new Robot().createScreenCapture(bounds), "png", file.toFile());
            System.out.printf(Locale.ROOT, "%s%n", file);
        }
        WindowRobot.ask(() -> {
            Look.apply(Theme.LIGHT, 100);
            return null;
        });
    }
}
