package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.text;
import static org.sami.crw.gui.SessionWorld.until;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.window.WindowSettings;

/** No mission looks as if it ran while the engine does not work. */
@Timeout(300)
class StandingStillTest {
    @TempDir
    private Path folder;

    @Test
    void aMissionStandsStillInAmberOnceTheEngineHasStoppedAndButtonsSayWhy() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            MissionMonitor monitor = laidOut(() -> new MissionMonitor(
                    world.context,
                    new MissionStarter(
                            world.context,
                            new WindowSettings(folder.resolve("settings")),
                            world.editors(),
                            values -> {}),
                    world.editors(),
                    new LoadedProject(Optional.empty())));
            world.start("clv");
            until("it runs", () -> text(monitor, "mission-state").startsWith("runs since"));

            world.session.host().fail("memory ran out");

            until("it stands still", () -> text(monitor, "mission-state").startsWith("stands still, runs since"));
            assertThat(onEventThread(
                            () -> find(monitor, "mission-state", JLabel.class).getForeground()))
                    .isEqualTo(SemanticColor.WARNING.get());
            List<String> refused = new CopyOnWriteArrayList<>();
            onEventThread(() -> {
                world.context.notices().addListener(notice -> refused.add(notice.text()));
                return null;
            });
            until("the button says why", () -> {
                world.run("mission-start"); // the first press may only bring the selected plan into sight
                return refused.stream().anyMatch(text -> text.contains("memory ran out"));
            });
        }
    }
}
