package org.sami.crw.gui;

import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.DefaultAnswers;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.session.Session;
import org.sami.crw.sim.run.operator.SimulatedOperatorDriver;
import org.sami.palette.Theme;
import org.sami.spn.protocol.Question;
import org.sami.spn.testing.TemporaryFolder;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.look.Look;

/**
 * Opens the window on a domain in the arrangement with the robots on the left and one large map, runs a mission, and makes pictures of it: of an allocation that is to be chosen,
 * of the Gantt chart, and of the mission's net.
 */
final class ArrangementScenes {
    private static final int FLEET = 5;
    private static final int LONG_S = 45; // until something can be seen of the mission
    private static final long ANSWER_MS = 1500;
    private static final long LATE_MS = 25_000; // so long a decision stays for its pictures

    private final Path pictures;
    private final WindowRobot robot = new WindowRobot();
    private final List<Integer> scales;
    private OpenedWindow opened;

    private ArrangementScenes(Path pictures, List<Integer> scales) {
        this.pictures = pictures;
        this.scales = scales;
    }

    /**
     * Makes the pictures.
     *
     * @param args the folder that they go to, the domain, plans with a comma between, each with ? that asks to choose among options, what begins their names, and scales in percent
     */
    public static void main(String[] args) throws Exception {
        List<Integer> scales = IntStream.range(4, args.length)
                .mapToObj(i -> Integer.valueOf(args[i]))
                .toList();
        int code = 1;
        try (TemporaryFolder data = new TemporaryFolder("crw-arrangement")) {
            new ArrangementScenes(Path.of(args[0]), scales).run(args[1], args[2], args[3], data.path());
            code = 0;
        } catch (AssertionError fault) {
            System.err.println(fault.getMessage());
        }
        System.exit(code); // threads of the window's session may last
    }

    private void run(String domain, String plan, String name, Path data) throws Exception {
        opened = OpenedWindow.open(
                new StartOptions(
                        List.of(),
                        Optional.empty(),
                        Optional.of(Theme.LIGHT),
                        Optional.of(100),
                        Optional.of(false),
                        Optional.empty(),
                        Optional.empty(),
                        Optional.empty(),
                        StartOptions.Near.WHEN_ASKED,
                        domain),
                data);
        robot.untilSaid("boats-count", FLEET + " of " + FLEET);
        command("arrangement-aims");
        answer(plan.contains("?") ? LATE_MS : ANSWER_MS);
        for (String given : plan.split(",", -1)) {
            boolean asks = given.endsWith("?");
            String each = asks ? given.substring(0, given.length() - 1) : given;
            session().start(each, each, Map.of());
            robot.until(
                    each + " asks nothing, or to choose among options",
                    () -> session().models().missions().snapshot().running().stream()
                                    .anyMatch(mission -> mission.plan().equals(each))
                            && (asks ? asksForOptions() : moving()));
            if (asksForOptions()) {
                command("panel-decisions");
                picture(name + "-decision");
            }
            robot.until("robots move", this::moving);
            pass(LONG_S);
        }
        command("panel-missions");
        picture(name + "-net");
        command("panel-gantt");
        picture(name + "-gantt");
        opened.end();
    }

    private boolean asksForOptions() {
        return session().models().decisions().snapshot().stream()
                .anyMatch(one -> one.decision().question() instanceof Question.ChooseOption);
    }

    private boolean moving() {
        return session().models().fleet().snapshot().stream()
                .anyMatch(boat -> boat.command().isPresent());
    }

    private Session session() {
        return opened.window().session();
    }

    private void command(String id) throws Exception {
        WindowRobot.ask(() -> {
            opened.window().commands().get(id).run();
            return null;
        });
        pass(1);
    }

    /** Has all decisions answered after a time. */
    private void answer(long afterMillis) {
        List<String> names = session().models().fleet().snapshot().stream()
                .map(boat -> boat.boat())
                .toList();
        GeoPoint at = session()
                .models()
                .fleet()
                .snapshot()
                .get(0)
                .pose()
                .orElseThrow()
                .position();
        GeoPoint centre = GeoPoint.of(at.latDeg(), at.lonDeg() + 0.003);
        DefaultAnswers defaults = new DefaultAnswers(at, centre, 150, 6, 1, names);
        SimulatedOperatorDriver driver = new SimulatedOperatorDriver(
                new SimulatedOperator(session().setup().vocabulary(), defaults, AnswersFile.EMPTY),
                session().scheduler(),
                afterMillis,
                at);
        session().execute(() -> {
            session().addOperator(driver);
            driver.connect(session());
        });
    }

    private static void pass(int seconds) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
        while (System.nanoTime() < end) {
            LockSupport.parkNanos(end - System.nanoTime());
        }
    }

    private void picture(String scene) throws Exception {
        for (int scale : scales) {
            for (Theme theme : Theme.values()) {
                WindowRobot.ask(() -> {
                    Look.apply(theme, scale);
                    return null;
                });
                pass(2);
                Rectangle bounds = WindowRobot.ask(() -> new Rectangle(
                        opened.window().frame().getRootPane().getLocationOnScreen(),
                        opened.window().frame().getRootPane().getSize()));
                BufferedImage seen = inFewerShades(new Robot().createScreenCapture(bounds));
                String file = scene + (theme == Theme.LIGHT ? "" : "-" + theme.id()) + (scale == 100 ? "" : "-" + scale)
                        + ".png";
                ImageIO.write(seen, "png", new File(pictures.toFile(), file));
                System.out.println(pictures.resolve(file));
            }
        }
        WindowRobot.ask(() -> {
            Look.apply(Theme.LIGHT, 100);
            return null;
        });
        pass(1);
    }

    /** The same in 32 shades of each colour, with which a picture that shows photographs has two thirds of the bytes. */
    private static BufferedImage inFewerShades(BufferedImage image) {
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                int rgb = image.getRGB(x, y);
                image.setRGB(x, y, (shade(rgb >> 16) << 16) | (shade(rgb >> 8) << 8) | shade(rgb));
            }
        }
        return image;
    }

    private static int shade(int value) {
        return (int) Math.round((value & 255) * 31 / 255.0) * 255 / 31;
    }
}
