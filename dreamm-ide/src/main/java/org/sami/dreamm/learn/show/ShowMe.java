package org.sami.dreamm.learn.show;

import java.awt.Component;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLayeredPane;
import javax.swing.JRootPane;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.border.Border;
import org.jspecify.annotations.Nullable;
import org.sami.dreamm.context.DreammContext;
import org.sami.lessons.script.EditScript;
import org.sami.lessons.script.ScriptElement;
import org.sami.lessons.script.ScriptRun;
import org.sami.spn.model.Project;
import org.sami.ui.command.Command;
import org.sami.ui.look.Look;
import org.sami.ui.net.NetView;

/**
 * Plays edits in the window's editor on a copy: a pointer goes to the palette, the net and the inspector, and each edit is made there. The author's own
 * project comes back when it ends, with its history and what was selected. One for a window; on the event thread.
 */
public final class ShowMe {
    private static final int FRAME_MS = 25;
    private static final double LONGEST_FRAME_MS = 200;

    private final DreammContext context;
    private final ShowCommands commands;
    private Optional<Playing> playing = Optional.empty();

    /** The player of a window, whose commands are added to its registry. */
    public ShowMe(DreammContext context) {
        this.context = Objects.requireNonNull(context, "context");
        commands = new ShowCommands(context.commands(), this::model, this::stop);
        context.document().addListener(change -> {
            if (change.isOpened() && !context.document().isLent()) {
                stop(); // the author saves, or opens something
            }
        });
    }

    /**
     * Shows a script, beginning at once. What was shown before ends.
     *
     * @param inside a component of the window
     * @param project with which it begins; it is copied
     * @param onEnd is run when it is over: all was shown and the learner has gone on, or stopped
     */
    public void start(Component inside, Project project, EditScript script, Runnable onEnd) {
        stop();
        JRootPane root = SwingUtilities.getRootPane(inside);
        ScriptRun run = script.applyTo(project, context.domain());
        playing = Optional.of(new Playing(root, new ShowMeModel(run), onEnd));
        playing.get().begin();
    }

    /** Ends what is shown; changes nothing where nothing is. */
    public void stop() {
        Optional<Playing> ends = playing;
        playing = Optional.empty();
        ends.ifPresent(Playing::end);
    }

    /** Whether something is shown. */
    public boolean isShown() {
        return playing.isPresent();
    }

    /** What is shown now. */
    public Optional<ShowMeModel> model() {
        return playing.map(now -> now.model);
    }

    /** One script that is shown, from its beginning to its end. */
    private final class Playing {
        private final JRootPane root;
        private final ShowMeModel model;
        private final Runnable onEnd;
        private final ShownCopy copy;
        private final ShowBar bar = new ShowBar(commands);
        private final ShowOverlay overlay = new ShowOverlay(bar);
        private final ShowTargets targets;
        private final ShowKeys keys;
        private final Timer timer = new Timer(FRAME_MS, e -> frame());
        private final Optional<Component> focusedBefore;
        private final Runnable look = this::looksDifferent;
        private final ComponentAdapter resized = new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                place();
            }
        };
        private Optional<ShowStop> prepared = Optional.empty();
        private Point from = new Point();
        private long last;
        private int room;
        private final @Nullable Border borderBefore;

        Playing(JRootPane root, ShowMeModel model, Runnable onEnd) {
            this.root = root;
            borderBefore = root.getContentPane() instanceof JComponent content ? content.getBorder() : null;
            this.model = model;
            this.onEnd = onEnd;
            focusedBefore =
                    Optional.ofNullable(SwingUtilities.getWindowAncestor(root).getMostRecentFocusOwner());
            targets = new ShowTargets(context, root);
            keys = new ShowKeys(context.commands(), commands, root, overlay);
            copy = new ShownCopy(context.document(), context.editor(), model.project());
        }

        void begin() {
            root.getLayeredPane().add(overlay, JLayeredPane.DRAG_LAYER);
            root.getLayeredPane().addComponentListener(resized);
            Look.addListener(look);
            keys.install();
            model.addListener(this::changed);
            bar.show(model);
            place();
            from = new Point(overlay.getWidth() / 2, overlay.getHeight() / 2);
            overlay.point(Optional.of(from), Optional.empty());
            bar.focus();
            last = System.nanoTime();
            timer.start();
            model.play();
            if (model.size() == 0) {
                changed();
            }
        }

        /** The panels give the bar a row of its own, so that it hides nothing of the net. */
        private void place() {
            if (overlay.getWidth() != root.getLayeredPane().getWidth()) {
                overlay.forgetHeight();
            }
            overlay.setSize(root.getLayeredPane().getSize());
            int height = overlay.barHeight();
            if (height != room && root.getContentPane() instanceof JComponent content) {
                room = height;
                content.setBorder(BorderFactory.createEmptyBorder(0, 0, height, 0));
                root.validate();
                overlay.revalidate();
                targets.net().ifPresent(NetView::fit);
            }
        }

        private void looksDifferent() {
            overlay.forgetHeight();
            place();
        }

        private void frame() {
            long now = System.nanoTime();
            double ms = Math.min(LONGEST_FRAME_MS, (now - last) / 1e6);
            last = now;
            model.tick(ms);
            if (playing.filter(each -> each == this).isPresent()) {
                point();
            }
        }

        private void point() {
            place();
            Optional<ShowStop> stop = model.stop();
            if (!stop.equals(prepared)) {
                prepared = stop;
                from = overlay.pointer().orElse(from);
                stop.ifPresent(targets::prepare);
            }
            Optional<Rectangle> aim = stop.flatMap(to -> targets.of(to, overlay));
            if (aim.isPresent()) {
                overlay.point(Optional.of(between(from, tip(aim.get()), model.way())), aim);
            } else if (stop.isEmpty()) {
                overlay.point(overlay.pointer(), Optional.empty());
            }
        }

        /** The pointer's tip lies in the middle of small things and near the left edge of wide ones, whose words it would hide. */
        private static Point tip(Rectangle aim) {
            int x = aim.width > 3 * aim.height ? aim.x + aim.height : aim.x + aim.width / 2;
            return new Point(x, aim.y + aim.height / 2);
        }

        private static Point between(Point a, Point b, double way) {
            double eased = way * way * (3 - 2 * way);
            return new Point((int) (a.x + (b.x - a.x) * eased), (int) (a.y + (b.y - a.y) * eased));
        }

        private void changed() {
            int before = copy.shown();
            Set<String> added = copy.show(model);
            if (!added.isEmpty()) {
                targets.net().ifPresent(net -> net.revealWhole(added));
            }
            if (model.done() == before + 1) {
                model.last().map(ScriptRun.Done::element).ifPresent(this::give);
            }
            bar.show(model);
            commands.show(model);
            overlay.revalidate();
            prepared = model.stop().isEmpty() ? Optional.empty() : prepared;
        }

        /** Runs a command of the view; undo and redo are in the project already. */
        private void give(ScriptElement element) {
            if (element instanceof ScriptElement.Give give
                    && (give.id().startsWith("net-") || give.id().startsWith("panel-"))) {
                context.commands().find(give.id()).ifPresent(Command::run);
            }
        }

        void end() {
            timer.stop();
            keys.remove();
            Look.removeListener(look);
            root.getLayeredPane().removeComponentListener(resized);
            root.getLayeredPane().remove(overlay);
            if (root.getContentPane() instanceof JComponent content) {
                content.setBorder(borderBefore);
            }
            root.validate();
            root.getLayeredPane().repaint();
            copy.giveBack();
            targets.net().ifPresent(NetView::fit);
            commands.ended();
            context.commands().refresh();
            focusedBefore.filter(Component::isShowing).ifPresent(Component::requestFocusInWindow);
            onEnd.run();
        }
    }
}
