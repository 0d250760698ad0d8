package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.rows;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.FocusEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.map.MapPanel;
import org.sami.crw.gui.notice.MessagesPanel;
import org.sami.crw.gui.picture.ShownPictures;
import org.sami.spn.model.Project;

/** Plans leave messages and map alone while the operator works there, where their markup says so (thesis 5.3). */
@Timeout(900)
class ManipulationTest {
    private static final String LIMITED = """
            {'id': '%1$s', 'name': '%1$s', 'places': [
              {'id': 'say', 'name': 'Say', 'start': true, 'outputs': [
                {'id': 'm', 'type': 'DisplayMessage', 'fields': {'message': {'value': 'for %1$s'}}, 'markups': [
                  {'type': 'RelevantArea', 'options': {'source': 'RELEVANT_PROXIES'}},
                  {'type': 'ManipulationComponent', 'options': {'limit': '%1$s'}}]}]}],
             'transitions': [], 'inEdges': [], 'outEdges': []}""";
    private static final Project PROJECT = SessionWorld.project(
            """
            {'formatVersion': 1, 'id': 'limits', 'name': 'Limits', 'domain': 'crw',
             'missionTree': [{'label': 'All', 'children': [
               {'plan': 'FOCUS_SUPPRESS'}, {'plan': 'TIMED_SUPPRESS'}, {'plan': 'free'}]}],
             'plans': [
              {'id': 'free', 'name': 'Free', 'places': [
                {'id': 'say', 'name': 'Say', 'start': true, 'outputs': [
                  {'id': 'm', 'type': 'DisplayMessage', 'fields': {'message': {'value': 'for all'}}}]}],
               'transitions': [], 'inEdges': [], 'outEdges': []},
            """ + String.join(",", List.of(LIMITED.formatted("FOCUS_SUPPRESS"), LIMITED.formatted("TIMED_SUPPRESS")))
                    + "]}");

    private SessionWorld world;

    @BeforeEach
    void open() throws Exception {
        world = new SessionWorld(PROJECT);
    }

    @AfterEach
    void close() throws Exception {
        world.close();
    }

    @Test
    void messagesAreNotChangedWhileTheFocusIsThereNorJustAfterTheirUse() throws Exception {
        MessagesPanel panel =
                laidOut(() -> new MessagesPanel(world.context, (boats, text) -> {}, new ShownPictures(world.context)));
        focus(panel, "messages-table", true);
        world.start("FOCUS_SUPPRESS");
        world.start("free");
        untilShown(panel, "for all");
        assertThat(rows(panel, "messages-table")).doesNotContain("FOCUS_SUPPRESS");

        focus(panel, "messages-table", false);
        world.start("FOCUS_SUPPRESS");
        untilShown(panel, "for FOCUS_SUPPRESS");

        turnWheel(panel, "messages-table");
        world.start("TIMED_SUPPRESS");
        world.start("FOCUS_SUPPRESS");
        SessionWorld.until(
                "the message after it is shown",
                () -> rows(panel, "messages-table").split("for FOCUS_SUPPRESS", -1).length == 3);
        assertThat(rows(panel, "messages-table")).doesNotContain("TIMED_SUPPRESS");
    }

    @Test
    void mapIsNotMovedWhileTheFocusIsThereNorJustAfterItsUse() throws Exception {
        MapPanel panel = laidOut(() -> new MapPanel(world.context));
        focus(panel, "map-canvas", true);
        world.start("FOCUS_SUPPRESS");
        untilHeldBack("the operator works with the map");

        focus(panel, "map-canvas", false);
        world.start("FOCUS_SUPPRESS");
        SessionWorld.until("it may change the map", () -> heldBack().isEmpty());

        turnWheel(panel, "map-canvas");
        world.start("TIMED_SUPPRESS");
        untilHeldBack("the operator used the map just now");
        onEventThread(() -> {
            panel.close();
            return null;
        });
    }

    private String heldBack() {
        return world.context.models().map().snapshot().heldBack();
    }

    private void untilHeldBack(String why) {
        SessionWorld.until(why, () -> heldBack().endsWith(why));
    }

    private static void untilShown(Container panel, String message) {
        SessionWorld.until(
                message + " is shown", () -> rows(panel, "messages-table").contains(message));
    }

    /** Has a view hear that the focus has come or gone: without a display there is none. */
    private static void focus(Container panel, String view, boolean on) {
        Component focused = SessionWorld.find(panel, view, JComponent.class);
        FocusEvent event = new FocusEvent(focused, on ? FocusEvent.FOCUS_GAINED : FocusEvent.FOCUS_LOST);
        onEventThread(() -> {
            List.of(focused.getFocusListeners()).forEach(listener -> {
                if (on) {
                    listener.focusGained(event);
                } else {
                    listener.focusLost(event);
                }
            });
            return null;
        });
    }

    private static void turnWheel(Container panel, String view) {
        JComponent named = SessionWorld.find(panel, view, JComponent.class);
        Container scrolled = SwingUtilities.getAncestorOfClass(JScrollPane.class, named); // hears it on a display
        Component turned = scrolled == null ? named : scrolled;
        onEventThread(() -> {
            turned.dispatchEvent(new MouseWheelEvent(
                    turned, MouseEvent.MOUSE_WHEEL, 0, 0, 20, 20, 0, false, MouseWheelEvent.WHEEL_UNIT_SCROLL, 1, 1));
            return null;
        });
    }
}
