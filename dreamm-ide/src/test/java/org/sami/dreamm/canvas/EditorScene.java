package org.sami.dreamm.canvas;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.Action;
import javax.swing.KeyStroke;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.ui.command.Command;
import org.sami.ui.window.Notices;

/** A model view over a project, without a window; the pointer and the keys as an author has them. */
final class EditorScene implements AutoCloseable {
    static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    final DreammContext context;
    final ModelView view;
    final List<Notices.Notice> notices = new ArrayList<>();

    EditorScene(Project project) {
        this(project, Profile.ALL);
    }

    EditorScene(Project project, Profile profile) {
        context =
                new DreammContext(DOMAIN, new ProjectDocument(DOMAIN.vocabulary(), project, Optional.empty()), profile);
        context.notices().addListener(notices::add);
        context.commands().add(new Command("undo", "Undo", context::undo));
        context.commands().add(new Command("redo", "Redo", context::redo));
        view = new ModelView(context);
        view.setSize(1400, 900);
        layOut(view);
        awaitEvents();
        view.net().fit();
    }

    /** That sizes were set is told on the event thread, and the view then shows all: it is over before the author begins. */
    private static void awaitEvents() {
        if (!EventQueue.isDispatchThread()) {
            try {
                EventQueue.invokeAndWait(() -> {});
            } catch (InterruptedException | InvocationTargetException e) {
                throw new AssertionError(e);
            }
        }
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component each : container.getComponents()) {
            if (each instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    /** A scene with one plan of the library open. */
    static EditorScene of(String plan) {
        EditorScene scene = new EditorScene(DOMAIN.combined());
        scene.context.editor().open(plan);
        scene.view.net().fit();
        return scene;
    }

    Plan plan() {
        return context.editor().plan().orElseThrow();
    }

    String text() {
        return new ProjectWriter(DOMAIN.vocabulary()).text(context.document().project());
    }

    Vertex vertex(String id) {
        return view.net().drawing().vertices().stream()
                .filter(vertex -> vertex.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    Point2D pixel(String id) {
        return view.net().pixel(vertex(id).centre().x(), vertex(id).centre().y());
    }

    void click(String id, int modifiers) {
        Point2D at = pixel(id);
        mouse(MouseEvent.MOUSE_PRESSED, at.getX(), at.getY(), modifiers, 1);
        mouse(MouseEvent.MOUSE_RELEASED, at.getX(), at.getY(), modifiers, 1);
    }

    void doubleClick(double x, double y) {
        for (int i = 1; i <= 2; i++) {
            mouse(MouseEvent.MOUSE_PRESSED, x, y, 0, i);
            mouse(MouseEvent.MOUSE_RELEASED, x, y, 0, i);
        }
    }

    void drag(Point2D from, double dx, double dy, int modifiers) {
        mouse(MouseEvent.MOUSE_MOVED, from.getX(), from.getY(), 0, 0);
        mouse(MouseEvent.MOUSE_PRESSED, from.getX(), from.getY(), modifiers, 1);
        for (int i = 1; i <= 4; i++) {
            mouse(MouseEvent.MOUSE_DRAGGED, from.getX() + dx * i / 4, from.getY() + dy * i / 4, modifiers, 1);
        }
        mouse(MouseEvent.MOUSE_RELEASED, from.getX() + dx, from.getY() + dy, modifiers, 1);
    }

    void mouse(int id, double x, double y, int modifiers, int clicks) {
        int down = id == MouseEvent.MOUSE_MOVED ? 0 : MouseEvent.BUTTON1_DOWN_MASK;
        int button = id == MouseEvent.MOUSE_MOVED || id == MouseEvent.MOUSE_DRAGGED
                ? MouseEvent.NOBUTTON
                : MouseEvent.BUTTON1;
        view.net()
                .canvas()
                .dispatchEvent(new MouseEvent(
                        view.net().canvas(), id, 0, modifiers | down, (int) x, (int) y, clicks, false, button));
    }

    /** Presses a key as if the net had the focus. */
    void key(String stroke) {
        Object name = view.net().canvas().getInputMap().get(KeyStroke.getKeyStroke(stroke));
        Action action = view.net().canvas().getActionMap().get(name);
        if (action.isEnabled()) {
            action.actionPerformed(null);
        }
    }

    void run(String command) {
        context.commands().get(command).run();
    }

    String lastNotice() {
        return notices.get(notices.size() - 1).text();
    }

    BufferedImage paint() {
        BufferedImage image = new BufferedImage(view.getWidth(), view.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        view.paint(g);
        g.dispose();
        return image;
    }

    @Override
    public void close() {
        context.close();
    }
}
