package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.press;
import static org.sami.crw.gui.SessionWorld.text;
import static org.sami.crw.gui.SessionWorld.until;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.ui.check.Layout;
import org.sami.ui.look.Look;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.window.WindowSettings;

/** The tab of a mission that cannot go on says so in amber, and sends again what failed. */
@Timeout(300)
class StuckBarTest {
    /** A boat goes to a point; nothing is planned for a path that fails. */
    private static final String PLAN = """
            {'formatVersion': 1, 'id': 'p', 'name': 'P', 'domain': 'crw', 'plans': [{
              'id': 'drive', 'name': 'Drive there',
              'places': [
                {'id': 'drive', 'name': 'Under way', 'start': true, 'outputs': [{'id': 'go', 'type': 'ProxyGotoPoint',
                  'fields': {'points': {'value': {'anna': {'lat': 45.404, 'lon': 10.9}}}}}]},
                {'id': 'end', 'end': true}],
              'transitions': [{'id': 'there', 'name': 'There', 'inputs': [{'id': 'i2', 'type': 'ProxyPathCompleted'}]}],
              'inEdges': [{'id': 'e2', 'place': 'drive', 'transition': 'there',
                'requirements': [{'match': 'all', 'kind': 'relevant'}]}],
              'outEdges': [{'id': 'o2', 'transition': 'there', 'place': 'end',
                'requirements': [{'action': 'take', 'n': 'all', 'kind': 'relevant'}]}]}]}
            """;

    @TempDir
    private Path folder;

    @Test
    void aMissionThatCannotGoOnSaysSoWithWhatWouldHelpAndSendsAgainWhatFailed() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.project(PLAN), "anna")) {
            MissionMonitor monitor = laidOut(() -> new MissionMonitor(
                    world.context,
                    new MissionStarter(
                            world.context,
                            new WindowSettings(folder.resolve("settings")),
                            world.editors(),
                            values -> {}),
                    world.editors(),
                    new LoadedProject(Optional.empty())));
            world.start("drive");
            until("anna has a command", () -> current(world).isPresent());
            assertThat(onEventThread(
                            () -> find(monitor, "mission-stuck", StuckBar.class).isVisible()))
                    .isFalse();
            assertThat(world.whyNot("mission-send-again")).isNotEmpty();

            SessionWorld.get(world.session
                    .fleet()
                    .cancel("anna", onEventThread(() -> current(world).orElseThrow())));

            until("it is stuck", () -> text(monitor, "mission-state").startsWith("stuck, runs since"));
            for (int height : List.of(500, 200)) {
                onEventThread(() -> {
                    Layout.layOut(monitor, Look.px(700), Look.px(height));
                    return null;
                });
                assertThat(text(monitor, "mission-stuck-text"))
                        .startsWith("Stuck since ")
                        .contains("anna cannot go on in 'Under way': the operator cancelled it")
                        .contains("Send it again, or complete or abort the mission");
                assertThat(onEventThread(() ->
                                find(monitor, "mission-stuck", StuckBar.class).getHeight()))
                        .isGreaterThan(20);
            }
            assertThat(onEventThread(
                            () -> find(monitor, "mission-state", JLabel.class).getForeground()))
                    .isEqualTo(SemanticColor.WARNING.get());

            press(monitor, "mission-send-again");

            until("anna has its command again", () -> current(world).isPresent());
            until(
                    "it goes on",
                    () -> !find(monitor, "mission-stuck", StuckBar.class).isVisible());
        }
    }

    private static Optional<String> current(SessionWorld world) {
        return world.context.models().commands().snapshot().stream()
                .flatMap(boat -> boat.queue().current().stream())
                .map(entry -> entry.command().commandId())
                .findFirst();
    }
}
