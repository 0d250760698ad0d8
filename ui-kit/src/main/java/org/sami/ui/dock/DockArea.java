package org.sami.ui.dock;

import io.github.andrewauclair.moderndocking.DockableTabPreference;
import io.github.andrewauclair.moderndocking.api.DockingAPI;
import io.github.andrewauclair.moderndocking.app.Docking;
import io.github.andrewauclair.moderndocking.app.RootDockingPanel;
import io.github.andrewauclair.moderndocking.event.DockingListener;
import io.github.andrewauclair.moderndocking.event.MaximizeListener;
import io.github.andrewauclair.moderndocking.exception.DockingLayoutException;
import io.github.andrewauclair.moderndocking.internal.DockedSimplePanel;
import io.github.andrewauclair.moderndocking.layouts.ApplicationLayout;
import io.github.andrewauclair.moderndocking.settings.Settings;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.LayoutFocusTraversalPolicy;
import javax.swing.Timer;
import javax.swing.UIManager;
import javax.swing.plaf.InputMapUIResource;
import org.sami.ui.EventThread;
import org.sami.ui.look.Look;

/**
 * Where the panels of a window lie. The arrangement is kept in a file as it changes; a file that cannot be used gives the program's own, which
 * fits the window's size and the size of letters, and changes with them as long as nobody has moved a panel.
 * One a process at a time: Modern Docking keeps state for the process until it is {@linkplain #close closed}. On the event thread.
 */
public final class DockArea extends JPanel implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(DockArea.class.getName());

    private static final int SAVE_MS = 500; // after the last change of many
    private static final LayoutFocusTraversalPolicy FIRST_IN = new LayoutFocusTraversalPolicy();

    private final Map<String, DockPanel> panels = new LinkedHashMap<>();
    private final JFrame frame;
    private final Path remembered;
    private final Map<String, String> keys = new HashMap<>();
    private Arrangements offered;
    private final Runnable adapting = this::adapt;
    private final RootDockingPanel root;
    private final FoldedPanels folded;
    private Optional<DockPanel> alone = Optional.empty();
    private Optional<Arrangement> fitted = Optional.empty();
    private Optional<String> trouble = Optional.empty();
    private final SplitProportions proportions;
    private final PointerRest pointer = PointerRest.watch();
    private final Timer saving = new Timer(SAVE_MS, event -> save());
    private final DockingListener docked = event -> {
        changed();
        EventThread.later(this::showFolded);
    };
    private final MaximizeListener enlarged = (panel, large) -> changed();
    private final boolean folds;
    private boolean arranged;

    /**
     * An area in a frame. Its arrangement is made by {@link #arrange}, once the frame has its size.
     *
     * @param offered how they lie at first; panels that it names and that are not there leave their place to the next
     * @param remembered the file of the arrangement
     */
    public DockArea(JFrame frame, List<DockPanel> panels, Arrangements offered, Path remembered) {
        super(null);
        this.frame = frame;
        this.remembered = remembered;
        setName("dock-area");
        // function keys are the window's commands': split panes of Swing's would take F6 and F8
        UIManager.put("SplitPane.ancestorInputMap", new InputMapUIResource());
        Settings.setDefaultTabPreference(DockableTabPreference.TOP);
        Settings.setActiveHighlighterEnabled(false);
        Docking.initialize(frame);
        root = new RootDockingPanel(frame);
        folded = new FoldedPanels(
                this,
                this::unfoldAll,
                () -> alone.ifPresent(DockArea::focus),
                this::pressed,
                panel -> keys.getOrDefault(panel.getPersistentID(), ""));
        add(root);
        proportions = SplitProportions.keep(root, this::changed);
        TabWidths.keep(root);
        ComponentWatch.on(root, DockArea::keepWithoutLines);
        TabKeys.leaveToCommands(root);
        panels.forEach(panel -> this.panels.put(panel.getPersistentID(), panel));
        this.offered = offered.of(this.panels.keySet());
        folds = this.offered.fold();
        panels.forEach(panel -> {
            panel.setFoldable(folds && !panel.getPersistentID().equals(this.offered.largest()));
            Docking.registerDockable(panel);
        });
        docking().getAppState().setPersistFile(remembered.toFile());
        docking()
                .getAppState()
                .setAutoPersist(false); // it would keep the places that dividers have while a side is empty
        saving.setRepeats(false);
        Docking.addDockingListener(docked);
        Docking.addMaximizeListener(enlarged);
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent resized) {
                adapt();
                changed();
            }
        });
        Look.addListener(adapting);
    }

    /** Modern Docking draws no lines around a panel without tabs at first, but does after a change of look. */
    private static void keepWithoutLines(Component found) {
        if (found instanceof DockedSimplePanel pane) {
            pane.addPropertyChangeListener("border", change -> {
                if (change.getNewValue() != null) {
                    pane.setBorder(null);
                }
            });
        }
    }

    /** Of this area: the library's classes with such names keep to the first one of the process. */
    private static DockingAPI docking() {
        return Docking.getSingleInstance();
    }

    private Arrangement fitting() {
        return offered.fitting(getWidth() > 0 ? getSize() : frame.getSize());
    }

    /** Where panels lie as the program has put them, and another of its arrangements fits better by now, that one is taken. */
    private void adapt() {
        if (!isSideBySide() || fitted.equals(Optional.of(fitting()))) {
            return;
        }
        Arrangement fit = fitting();
        fitted = Optional.of(fit);
        String now = DockShape.of(docking().getDockingState().getApplicationLayout());
        Set<String> placed = placed();
        if (isOf(now, Arrangement::layout)) {
            take(fit.layout(), now);
        } else if (folds && isOf(now, one -> one.with(placed).layout())) {
            take(fit.with(placed).layout(), now);
        }
    }

    private boolean isOf(String shape, Function<Arrangement, ApplicationLayout> layout) {
        return offered.all().stream()
                .map(layout)
                .anyMatch(one -> DockShape.of(one).equals(shape));
    }

    private void take(ApplicationLayout layout, String now) {
        if (DockShape.of(layout).equals(now)) {
            return;
        }
        Set<DockPanel> seen =
                panels.values().stream().filter(Component::isShowing).collect(Collectors.toSet());
        restore(layout);
        seen.forEach(panel -> keepInFront(panel, seen));
    }

    private void restore(ApplicationLayout layout) {
        Component focused =
                KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        docking().getDockingState().restoreApplicationLayout(layout);
        if (focused != null) {
            EventThread.later(() -> keepFocus(focused));
        }
    }

    /** What was in sight stays so where it lies behind a panel that was not: a decision, say, behind the missions. */
    private static void keepInFront(DockPanel panel, Set<DockPanel> seen) {
        boolean hidden =
                panel.inFrontOf().filter(front -> !seen.contains(front)).isPresent();
        if (hidden) {
            Docking.display(panel);
        }
    }

    private Set<String> placed() {
        return panels.keySet().stream().filter(Docking::isDocked).collect(Collectors.toSet());
    }

    /** The focus stays in the panels: what moves is taken out of the window meanwhile, and a key would reach what comes first in it. */
    private void keepFocus(Component focused) {
        Component next = focused.isShowing() ? focused : FIRST_IN.getFirstComponent(this);
        Optional.ofNullable(next).ifPresent(Component::requestFocusInWindow);
    }

    /**
     * Arranges the panels as they were left, with the frame where it was, if that is on a screen; as the program wants it where that is not known. From now
     * on changes are kept.
     */
    public void arrange() {
        docking().getAppState().setDefaultApplicationLayout(fitting().layout());
        Optional<String> fault = LayoutFile.fault(remembered);
        try {
            if (fault.isPresent()) {
                refuse(fault.get());
            } else {
                docking().getAppState().restore();
            }
        } catch (DockingLayoutException unfit) {
            refuse("it is no arrangement of these panels: " + unfit.getMessage());
        }
        ScreenFit.into(frame);
        arranged = true;
        showFolded();
        adapt();
        changed();
    }

    /** Has sides whose panels are all empty leave their room to others of their column; to be called a few times a second. */
    public void shareRoom() {
        if (isSideBySide()) {
            proportions.share(pointer::letsShrink, pointer::letsReturn, pointer::pressable);
        }
    }

    /** Whether the arrangement is one to be kept: none is while one panel has all the room. */
    private boolean isSideBySide() {
        return arranged && alone.isEmpty();
    }

    private void changed() {
        if (isSideBySide()) {
            saving.restart();
        }
    }

    private void save() {
        if (isSideBySide()) {
            proportions.inProportion(() -> {
                try {
                    docking()
                            .getLayoutPersistence()
                            .saveLayoutToFile(
                                    remembered.toFile(),
                                    docking().getDockingState().getApplicationLayout());
                } catch (DockingLayoutException unwritable) {
                    LOG.log(System.Logger.Level.WARNING, "the arrangement of panels cannot be kept", unwritable);
                }
            });
        }
    }

    /** Takes the program's arrangement in place of a file that is not read, which is kept under another name. */
    private void refuse(String why) {
        String kept;
        try {
            kept = "it was set aside as " + LayoutFile.setAside(remembered).getFileName();
        } catch (IOException fault) {
            kept = "it could not be set aside: " + fault.getMessage();
        }
        trouble = Optional.of(
                "the arrangement of panels in " + remembered.toAbsolutePath() + " is not used, " + why + "; " + kept);
        LOG.log(System.Logger.Level.WARNING, trouble.get());
        reset();
    }

    /** Why the remembered arrangement was not used, and where its file is now, one sentence without a full stop; empty where it was, or there was none. */
    public Optional<String> trouble() {
        return trouble;
    }

    // ---- Folding

    /** Where the program folds panels at first, those without a place stand in the strip at the edge. */
    private void showFolded() {
        if (folds && isSideBySide()) {
            folded.fold(panels.values().stream()
                    .filter(panel -> !Docking.isDocked(panel))
                    .toList());
        }
    }

    private void pressed(DockPanel panel) {
        if (alone.isPresent()) {
            folded.toggle(panel);
        } else {
            show(panel.getPersistentID());
        }
    }

    /** Puts a folded panel back among the others. */
    private void place(DockPanel panel) {
        fitting()
                .home(panel.getPersistentID(), Docking::isDocked)
                .ifPresentOrElse(
                        step -> Docking.dock(step.panel(), step.at(), step.region(), step.part()),
                        () -> Docking.display(panel));
        showFolded();
    }

    private void unfoldAll() {
        if (alone.isPresent()) {
            unfold();
        } else {
            panels.values().stream().filter(panel -> !Docking.isDocked(panel)).forEach(this::place);
        }
    }

    /** Gives a panel all the room and folds the others to the edge, or puts them back; a panel that is open over the edge is folded first. */
    public void toggleFolded(String panel) {
        if (alone.isPresent()) {
            unfold();
        } else {
            fold(named(panel));
        }
    }

    private void fold(DockPanel panel) {
        Docking.display(panel);
        Docking.maximize(panel);
        alone = Optional.of(panel);
        folded.fold(panels.values().stream().filter(each -> each != panel).toList());
        revalidate();
        repaint();
        focus(panel);
    }

    private void unfold() {
        alone.ifPresent(panel -> {
            folded.unfold();
            alone = Optional.empty();
            Docking.minimize(panel);
            showFolded();
            adapt();
            changed();
            revalidate();
            repaint();
            focus(panel);
        });
    }

    /** The panel that has all the room; empty where panels lie side by side. */
    public Optional<String> alone() {
        return alone.map(DockPanel::getPersistentID);
    }

    /** Says by which key a panel is shown, for the strip of folded ones. */
    public void setKey(String panel, String key) {
        keys.put(panel, key);
    }

    private static void focus(DockPanel shown) {
        shown.focus()
                .map(Component.class::cast)
                .or(() -> Optional.ofNullable(FIRST_IN.getFirstComponent(shown.content())))
                .ifPresent(Component::requestFocusInWindow);
    }

    @Override
    public void doLayout() {
        Rectangle all = new Rectangle(getSize());
        root.setBounds(folded.isShown() ? folded.layOut(all) : all);
    }

    @Override
    public boolean isOptimizedDrawingEnabled() {
        return alone.isEmpty(); // an open panel lies over the large one
    }

    @Override
    public Dimension getPreferredSize() {
        return root.getPreferredSize();
    }

    @Override
    public Dimension getMinimumSize() {
        return root.getMinimumSize();
    }

    /** Arranges the panels as another of the program's arrangements has it; that one fits itself to the window and is put back from now on. */
    public void arrange(Arrangements other) {
        offered = other.of(panels.keySet());
        reset();
    }

    /** Arranges the panels as the program wants it. */
    public void reset() {
        unfold();
        fitted = Optional.of(fitting());
        restore(fitting().layout());
        showFolded();
    }

    /** Brings a panel to the front, back into the window if it was closed, and the keyboard's focus to the first thing in it. */
    public void show(String panel) {
        DockPanel shown = named(panel);
        if (alone.isPresent() && folded.has(shown)) {
            folded.show(shown);
            focus(shown);
            return;
        }
        if (folds && alone.isEmpty() && !Docking.isDocked(shown)) {
            place(shown);
        }
        if (alone.isPresent()) {
            folded.close();
        } else {
            Docking.display(shown);
        }
        focus(shown);
    }

    private DockPanel named(String panel) {
        return Objects.requireNonNull(panels.get(panel), () -> "there is no panel " + panel);
    }

    /** The panels, in order. */
    public List<DockPanel> panels() {
        return List.copyOf(panels.values());
    }

    /** Keeps the arrangement, and gives up the process's docking. */
    @Override
    public void close() {
        unfold();
        Look.removeListener(adapting);
        pointer.close();
        saving.stop();
        save();
        arranged = false;
        Docking.removeDockingListener(docked);
        Docking.removeMaximizeListener(enlarged);
        Docking.deregisterAllDockables();
        Docking.deregisterAllDockingPanels();
        Docking.uninitialize();
    }
}
