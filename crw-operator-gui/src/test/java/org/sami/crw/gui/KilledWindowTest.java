package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.spn.protocol.Question;
import org.sami.spn.testing.JavaProcess;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;

/** The window dies in the middle of a mission, and another one goes on with what it left. */
@Tag("window")
class KilledWindowTest {
    @TempDir
    private Path folder;

    @Test
    void aWindowThatWasKilledIsGoneOnWithInAnother() throws Exception {
        RealDisplay.assumed();
        killOneInAMission();

        try (OpenedWindow opened = OpenedWindow.open(KilledWindow.options(true), folder)) {
            OperatorWindow window = opened.window();
            WindowRobot robot = new WindowRobot();
            robot.untilSaid("boats-count", "5 of 5");
            robot.untilSaid("missions-count", "1 mission");
            robot.untilSaid(
                    "decisions-count", "2 decisions"); // the mission's, and which of the restarted boats may move
            robot.until( // boats are asked about as they are heard, one after another
                    "all boats that started anew are asked about",
                    () -> window.session().models().decisions().snapshot().stream()
                            .anyMatch(waiting -> waiting.decision().question() instanceof Question.ChooseProxies choice
                                    && choice.proxies().equals(List.of("anna", "bert", "carl", "dora", "emil"))));
            assertThat(window.session().models().missions().snapshot().missions())
                    .singleElement()
                    .matches(mission -> !mission.hasEnded())
                    .extracting(MissionSnapshot::title)
                    .asString()
                    .contains("Explore Area");
        }
    }

    private void killOneInAMission() throws Exception {
        Process process = JavaProcess.builder(folder, KilledWindow.class, folder.toString())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        String said = process.inputReader(StandardCharsets.UTF_8).readLine();
        process.destroyForcibly().waitFor();
        assertThat(said).isEqualTo("runs");
    }
}
