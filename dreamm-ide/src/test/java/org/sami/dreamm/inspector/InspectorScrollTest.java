package org.sami.dreamm.inspector;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.issues.LiveFindings;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.json.DomainLibrary;
import org.sami.ui.EventThread;
import org.sami.ui.check.Layout;

/** What the author works at stays where it is in the inspector. Not on the event thread: carets scroll in events of their own. */
@Isolated("the look is one for all windows of a process")
class InspectorScrollTest {
    private static final int WIDTH = 340;
    private static final int HEIGHT = 360;
    private static final String FIELD = "field-spacing-source";

    private final List<Runnable> checking = new ArrayList<>();
    private DreammContext context;
    private InspectorPanel panel;

    @BeforeEach
    void open() {
        act(() -> {
            DomainLibrary library =
                    DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
            ProjectDocument document = new ProjectDocument(library.vocabulary(), library.combined(), Optional.empty());
            context = new DreammContext(library, document, Profile.ALL);
            context.editor().open("station-keep");
            context.editor().select(List.of("assemble"));
            panel = new InspectorPanel(
                    context, new LiveFindings(document, checking::add, Runnable::run, System::nanoTime));
            panel.addNotify();
            Layout.layOut(panel, WIDTH, HEIGHT);
            panel.validate();
        });
        act(() -> {
            JScrollPane scrolled = (JScrollPane) panel.getComponent(1);
            int top = SwingUtilities.convertPoint(
                            field(), 0, 0, scrolled.getViewport().getView())
                    .y;
            scrolled.getViewport().setViewPosition(new Point(0, top - 60));
        });
    }

    @AfterEach
    void close() {
        act(context::close);
    }

    private static void act(Runnable action) {
        EventThread.get(() -> {
            action.run();
            return true;
        });
    }

    private JComponent field() {
        return Layout.find(panel, FIELD, JComboBox.class).orElseThrow();
    }

    private int seenAt() {
        return EventThread.get(() -> SwingUtilities.convertPoint(field(), 0, 0, panel.getComponent(1)).y);
    }

    @Test
    void fieldStaysWhereItIsWhileItIsEdited() {
        int before = seenAt();

        act(() -> ((JComboBox<?>) field()).setSelectedItem(FieldOrigin.NOTHING));

        assertThat(seenAt()).isEqualTo(before).isBetween(0, HEIGHT);
    }

    @Test
    void findingThatComesAboveAFieldDoesNotMoveTheField() {
        act(() -> ((JComboBox<?>) field()).setSelectedItem(FieldOrigin.NOTHING));
        int before = seenAt();

        act(() -> {
            while (!checking.isEmpty()) {
                checking.remove(0).run();
            }
        });

        assertThat(EventThread.get(() -> Layout.find(panel, "inspector-findings", JComponent.class)
                        .orElseThrow()
                        .getComponentCount()))
                .isPositive();
        assertThat(seenAt()).isEqualTo(before);
    }

    @Test
    void findingsThatComeMoveNothingAtTheTopEither() {
        act(() -> ((JComboBox<?>) field()).setSelectedItem(FieldOrigin.NOTHING));
        act(() -> {
            Layout.find(panel, "inspector-name", JTextField.class).orElseThrow().requestFocusInWindow();
            ((JScrollPane) panel.getComponent(1)).getViewport().setViewPosition(new Point());
            for (int i = 0; i < 4; i++) {
                panel.validate(); // a text that wraps says its height only after it has a width
            }
        });
        List<Rectangle> before = places();

        check();
        assertThat(places()).isEqualTo(before);
        assertThat(EventThread.get(() -> Layout.find(panel, "inspector-findings", JComponent.class)
                        .orElseThrow()
                        .getHeight()))
                .isPositive();
    }

    private void check() {
        act(() -> {
            while (!checking.isEmpty()) {
                checking.remove(0).run();
            }
            panel.validate();
        });
    }

    /** Where the name, the last field and all around them are. */
    private List<Rectangle> places() {
        return EventThread.get(() -> Stream.of("inspector-name", "inspector-mode", "inspector-add-event")
                .map(name -> Layout.find(panel, name, JComponent.class).orElseThrow())
                .map(field -> SwingUtilities.convertRectangle(field.getParent(), field.getBounds(), panel))
                .toList());
    }

    @Test
    void anotherVertexIsShownFromItsTop() {
        act(() -> context.editor().select(Set.of("hold")));

        assertThat(EventThread.get(() ->
                        ((JScrollPane) panel.getComponent(1)).getViewport().getViewPosition()))
                .isEqualTo(new Point());
    }
}
