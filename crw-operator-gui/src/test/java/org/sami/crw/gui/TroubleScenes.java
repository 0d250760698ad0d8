package org.sami.crw.gui;

import static org.sami.crw.gui.SessionWorld.get;

import java.awt.Component;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.Statement;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.sami.boat.server.testing.Await;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.check.Layout;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.map.MapView;

/** What pictures of trouble show: each scene begins, is looked at, and is over again. */
final class TroubleScenes {
    private static final int CLOSED_PORT = 1;
    private static final GeoPoint BUOY = GeoPoint.of(25.3588, 51.5302);
    /** From the bay to the west of the fence. */
    private static final List<GeoPoint> ACROSS_THE_FENCE = List.of(
            GeoPoint.of(25.3606, 51.5254),
            GeoPoint.of(25.3606, 51.5290),
            GeoPoint.of(25.3588, 51.5290),
            GeoPoint.of(25.3588, 51.5254));

    private final OperatorWindow window;
    private final Path data;
    private final Look look;
    private final WindowRobot robot = new WindowRobot();

    /** Looks at a scene. */
    @FunctionalInterface
    interface Look {
        /** Makes a picture of it. */
        void at(String scene) throws Exception;
    }

    /**
     * Scenes of a window.
     *
     * @param data its data directory
     */
    TroubleScenes(OperatorWindow window, Path data, Look look) {
        this.window = window;
        this.data = data;
        this.look = look;
    }

    private Session session() {
        return window.session();
    }

    /** An area that is partly outside the fence, drawn on the large map. */
    void judgedAnswer() throws Exception {
        get(session().start("explore-team", "Explore the shore", Map.of()));
        robot.untilSaid("decisions-count", "1 decision");
        MapView map = Layout.find(window.frame(), "map", MapView.class).orElseThrow();
        for (GeoPoint corner : ACROSS_THE_FENCE) {
            int x = WindowRobot.ask(() -> (int) map.frame().px(corner));
            int y = WindowRobot.ask(() -> (int) map.frame().py(corner));
            robot.clickAt(map.canvas(), x, y);
        }
        robot.until(
                "it is judged",
                () -> Layout.find(window.frame(), "decision-judgement", Component.class)
                        .filter(Component::isVisible)
                        .isPresent());
        look.at("judged");
        end();
    }

    /** A lost boat is there already; an address at which nobody answers comes to it. */
    void links() throws Exception {
        BoatAddress nobody = new BoatAddress("127.0.0.1", CLOSED_PORT);
        session().fleet().connect(nobody);
        untilFault(HealthKind.UNREACHED_BOAT);
        WindowRobot.ask(() -> {
            window.commands().get("panel-health").run();
            return null;
        });
        look.at("links");
        get(session().fleet().disconnect(nobody));
        WindowRobot.ask(() -> {
            window.commands().get("panel-messages").run();
            return null;
        });
    }

    /** A boat whose path has failed, in a plan that has no answer to it. */
    void stuck(String boat) throws Exception {
        PlainDrive.stuck(session(), "Look at the buoy", boat, BUOY);
        look.at("stuck");
        end();
    }

    /** The fleet is stopped until it is released. */
    void fleetStop() throws Exception {
        get(session().fleet().stopAll());
        untilFault(HealthKind.FLEET_STOP);
        look.at("fleet-stop");
        get(session().fleet().releaseAll());
        Await.until(
                "nobody is stopped",
                () -> session()
                        .models()
                        .health()
                        .snapshot()
                        .of(HealthKind.FLEET_STOP)
                        .isEmpty());
    }

    /** Another program keeps the journal to itself: nothing can be written to it. */
    void journal() throws Exception {
        Path journal;
        try (Stream<Path> files = Files.walk(data.resolve("sessions"))) {
            journal = files.filter(file -> file.toString().endsWith(".journal"))
                    .findFirst()
                    .orElseThrow();
        }
        try (Connection other = DriverManager.getConnection("jdbc:sqlite:" + journal);
                Statement statement = other.createStatement()) {
            statement.execute("BEGIN IMMEDIATE");
            untilFault(HealthKind.JOURNAL); // as soon as the missions that run have news
            look.at("journal");
            statement.execute("ROLLBACK");
        }
        Await.until(
                "the journal is written again",
                () -> session()
                        .models()
                        .health()
                        .snapshot()
                        .of(HealthKind.JOURNAL)
                        .isEmpty());
    }

    private void untilFault(HealthKind kind) {
        Await.until(
                kind + " is known",
                () -> !session().models().health().snapshot().of(kind).isEmpty());
    }

    private void end() {
        session().abortAll();
        robot.until(
                "no mission runs",
                () -> session().models().missions().snapshot().missions().stream()
                        .filter(mission -> mission.parent() == Ids.NONE)
                        .allMatch(mission -> mission.hasEnded()));
        robot.click("mission-close");
    }
}
