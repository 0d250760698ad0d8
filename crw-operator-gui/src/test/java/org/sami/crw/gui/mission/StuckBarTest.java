package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.press;
import static org.sami.crw.gui.SessionWorld.text;
import static org.sami.crw.gui.SessionWorld.until;

import java.awt.Color;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.Icon;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.TextScale;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.palette.SemanticColor;
import org.sami.ui.check.Layout;
import org.sami.ui.look.Look;
import org.sami.ui.window.WindowSettings;

/** The tab of a mission that cannot go on says so in amber, and sends again what failed. */
@Isolated("the look is one for all windows of a process")
@Timeout(900)
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
        try (TextScale standard = TextScale.percent(100);
                SessionWorld world = new SessionWorld(SessionWorld.project(PLAN), "anna")) {
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
            JTabbedPane tabs = find(monitor, "mission-tabs", JTabbedPane.class);
            assertThat(onEventThread(() -> color(tabs.getIconAt(tabs.getSelectedIndex()))))
                    .as("its tab is marked")
                    .isEqualTo(SemanticColor.WARNING.get());
            for (int height : List.of(500, 250)) {
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

            for (int height : List.of(200, 160, 130, 100)) {
                onEventThread(() -> {
                    Layout.layOut(monitor, Look.px(700), Look.px(height));
                    Layout.layOut(monitor, Look.px(700), Look.px(height));
                    JLabel brief = find(monitor, "mission-stuck-brief", JLabel.class);
                    assertThat(brief.getText()).startsWith("Stuck: anna cannot go on");
                    assertThat(brief.getToolTipText()).contains("Send it again, or complete or abort the mission");
                    for (String name : List.of(
                            "mission-stuck-brief",
                            "mission-send-again-icon",
                            "mission-complete-icon",
                            "mission-abort-icon")) {
                        JComponent part = find(monitor, name, JComponent.class);
                        assertThat(isInSight(part, monitor))
                                .as("%s at %d", name, height)
                                .isTrue();
                        assertThat(part.getWidth()).as(name).isGreaterThanOrEqualTo(Look.px(32));
                    }
                    return null;
                });
            }

            press(monitor, "mission-send-again");

            until("anna has its command again", () -> current(world).isPresent());
            until(
                    "it goes on",
                    () -> !find(monitor, "mission-stuck", StuckBar.class).isVisible());
        }
    }

    private static boolean isInSight(JComponent part, JComponent whole) {
        return part.isVisible()
                && new Rectangle(whole.getSize())
                        .contains(SwingUtilities.convertRectangle(part.getParent(), part.getBounds(), whole));
    }

    /** The colour of most of an icon's pixels. */
    private static Color color(Icon icon) {
        BufferedImage image = new BufferedImage(icon.getIconWidth(), icon.getIconHeight(), BufferedImage.TYPE_INT_ARGB);
        icon.paintIcon(new JLabel(), image.getGraphics(), 0, 0);
        return IntStream.of(image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()))
                .filter(pixel -> pixel >>> 24 == 255)
                .boxed()
                .collect(Collectors.groupingBy(pixel -> pixel, Collectors.counting()))
                .entrySet()
                .stream()
                .max(Map.Entry.comparingByValue())
                .map(most -> new Color(most.getKey()))
                .orElseThrow();
    }

    private static Optional<String> current(SessionWorld world) {
        return world.context.models().commands().snapshot().stream()
                .flatMap(boat -> boat.queue().current().stream())
                .map(entry -> entry.command().commandId())
                .findFirst();
    }
}
