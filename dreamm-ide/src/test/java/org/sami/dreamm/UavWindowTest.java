package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_6;
import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_F5;
import static java.awt.event.KeyEvent.VK_F6;
import static java.awt.event.KeyEvent.VK_N;
import static java.awt.event.KeyEvent.VK_S;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JList;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.model.Place;
import org.sami.ui.check.WindowRobot;

/** The domain of docs/writing-a-domain.md, from its own files: its words alone are offered, and a plan of them is drawn, checked, tried, kept. */
@Tag("window")
class UavWindowTest {
    private static final Path DOMAIN =
            Path.of("..", "domain-config", "src", "main", "resources", "org", "sami", "domain", "uav");

    @Test
    void planOfAircraftIsDrawnCheckedTriedAndSaved(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("look.json");
        try (AuthorRobot author =
                AuthorRobot.open(folder.resolve("data"), Optional.of("look"), Optional.of(DOMAIN), Profile.ALL)) {
            assertThat(author.plan().id()).isEqualTo("look");
            author.robot.press(VK_N, VK_CONTROL);
            author.robot.until(
                    "a new project is open",
                    () -> author.document().project().plans().size() == 1);
            assertThat(author.document().project().domain()).isEqualTo("uav");
            author.mark("fly", "Fly To");
            JList<?> palette = author.palette();
            int offered = WindowRobot.ask(() -> palette.getModel().getSize());
            assertThat(offered).isEqualTo(5); // two groups with Fly To, Fly Path and Cannot Fly, none of the boats

            draw(author);
            author.robot.untilSaid("count-errors", "0");
            author.robot.untilSaid("count-warnings", "0");
            tryIt(author);
            author.robot.press(VK_S, VK_CONTROL);
            author.giveFile(file);
            author.robot.untilSaid("notice", "Saved in");
            assertThat(author.read(file))
                    .isEqualTo(WindowRobot.ask(() -> author.document().project()));
        }
        Crw.Outcome checked = Crw.run(
                folder,
                List.of("check", "--domain", DOMAIN.toAbsolutePath().normalize().toString(), file.toString()));
        assertThat(checked.code()).as(checked.said()).isZero();
    }

    private static void draw(AuthorRobot author) {
        author.add("choose aircraft", "Choose Aircraft");
        author.click(author.behind("AircraftChosen"));
        author.add("fly to", "Fly To");
        author.click(author.place("FlyTo"));
        author.robot.choose("field-location-source", "asked, can be changed");
        author.click(author.behind("ReachedLocation"));
        author.add("look around", "Look Around");
        author.click(author.behind("PictureTaken"));
        author.add("land", "Land");
        for (String end : author.plan().places().stream()
                .filter(p -> author.plan().inEdges().stream()
                        .noneMatch(e -> e.place().equals(p.id())))
                .map(Place::id)
                .toList()) {
            author.click(end);
            author.tick("inspector-end");
        }
    }

    private static void tryIt(AuthorRobot author) {
        author.robot.press(VK_6, VK_ALT);
        author.robot.untilShown("try-out-panel");
        author.robot.press(VK_F5);
        author.robot.untilSaid("try-where", "step 0");
        JLabel where = author.robot.find(JLabel.class, "try-where");
        int steps = 0;
        while (!WindowRobot.ask(() -> where.getText().contains("over: "))) {
            assertThat(++steps).as(WindowRobot.ask(where::getText)).isLessThan(20);
            author.robot.press(VK_F6);
            author.robot.untilSaid("try-where", "step " + steps);
        }
        assertThat(WindowRobot.ask(where::getText)).contains("over: ended");
    }
}
