package org.sami.ui.dock;

import io.github.andrewauclair.moderndocking.Dockable;
import io.github.andrewauclair.moderndocking.ui.DockingHeaderUI;
import io.github.andrewauclair.moderndocking.ui.HeaderController;
import io.github.andrewauclair.moderndocking.ui.HeaderModel;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.util.Objects;
import java.util.Optional;
import java.util.function.ObjIntConsumer;
import java.util.stream.Stream;
import javax.swing.Icon;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import org.sami.ui.look.Icons;
import org.sami.ui.look.PlainTextUI;

/** A panel that can be docked: a component with a stable id, under which its place is remembered. */
public final class DockPanel extends JPanel implements Dockable {
    private final String id;
    private String title;
    private final String icon;
    private final JComponent content;
    private Optional<JComponent> first = Optional.empty();
    private Optional<DockHeader> header = Optional.empty();
    private boolean waiting;
    private boolean empty;
    private boolean usesRoom;
    private boolean foldable;

    /**
     * A panel.
     *
     * @param id stable, in kebab case; the component's name as well
     * @param icon of {@link Icons}
     */
    public DockPanel(String id, String title, String icon, JComponent content) {
        super(new BorderLayout());
        this.id = Objects.requireNonNull(id, "id");
        this.title = Objects.requireNonNull(title, "title");
        this.icon = Objects.requireNonNull(icon, "icon");
        setName(id);
        getAccessibleContext().setAccessibleName(title);
        this.content = content;
        add(content);
    }

    /** Gives the keyboard's focus to a part of it when it is shown, instead of to the first thing in it that takes it. */
    public DockPanel withFocusOn(JComponent part) {
        first = Optional.of(part);
        return this;
    }

    /** Says that it shows more, or larger, with more room: it gets what empty panels above and below it leave. */
    public DockPanel withUseOfRoom() {
        usesRoom = true;
        return this;
    }

    boolean usesRoom() {
        return usesRoom;
    }

    /** What gets the keyboard's focus when it is shown; empty where that is the first thing in it that takes it. */
    Optional<JComponent> focus() {
        return first;
    }

    /** Its content, for code that shows it elsewhere for a while. */
    JComponent content() {
        return content;
    }

    /** Shows again what was shown elsewhere. */
    void takeBack() {
        add(content);
        revalidate();
    }

    /** What stands above it. */
    public String title() {
        return title;
    }

    /** Gives it another title, which its tab and the line above it show from now on; the place and the id stay. */
    public void retitle(String next) {
        if (!next.equals(title)) {
            title = next;
            getAccessibleContext().setAccessibleName(next);
            header.ifPresent(line -> line.retitle(next));
            onTab((tabs, index) -> tabs.setTitleAt(index, PlainTextUI.of(next)));
        }
    }

    @Override
    public String getPersistentID() {
        return id;
    }

    @Override
    public String getTabText() {
        return title;
    }

    @Override
    public Icon getIcon() {
        Icon plain = Icons.small(icon);
        return waiting ? new WaitingIcon(plain) : plain;
    }

    /** Marks its tab, where it lies behind another, as one in which something waits; the tab's width and place stay. */
    public void setWaiting(boolean waiting) {
        if (waiting != this.waiting) {
            this.waiting = waiting;
            onTab((tabs, index) -> tabs.setIconAt(index, getIcon()));
        }
    }

    /** Says that nothing is in it now: a side of the window whose panels are all empty leaves its room to others above and below it. */
    public void setEmpty(boolean empty) {
        this.empty = empty;
    }

    /** Says whether it is folded to the edge where it is closed. */
    void setFoldable(boolean foldable) {
        this.foldable = foldable;
    }

    boolean isFoldable() {
        return foldable;
    }

    boolean isEmpty() {
        return empty;
    }

    /** The panel of its stack that is in front of it; empty where it is in front itself, or in no stack. */
    Optional<DockPanel> inFrontOf() {
        return SwingUtilities.getAncestorOfClass(JTabbedPane.class, this) instanceof JTabbedPane tabs
                ? in(tabs.getSelectedComponent()).filter(front -> front != this)
                : Optional.empty();
    }

    private static Optional<DockPanel> in(@Nullable Component component) {
        if (component instanceof DockPanel panel) {
            return Optional.of(panel);
        }
        return component instanceof Container container
                ? Stream.of(container.getComponents())
                        .flatMap(child -> in(child).stream())
                        .findFirst()
                : Optional.empty();
    }

    private void onTab(ObjIntConsumer<JTabbedPane> change) {
        if (SwingUtilities.getAncestorOfClass(JTabbedPane.class, this) instanceof JTabbedPane tabs) {
            for (int i = 0; i < tabs.getTabCount(); i++) {
                if (SwingUtilities.isDescendingFrom(this, tabs.getComponentAt(i))) {
                    change.accept(tabs, i);
                }
            }
        }
    }

    @Override
    public boolean isAutoHideAllowed() {
        return false;
    }

    @Override
    public boolean isMinMaxAllowed() {
        return true;
    }

    @Override
    public boolean isWrappableInScrollpane() {
        return false;
    }

    @Override
    public DockingHeaderUI createHeaderUI(HeaderController controller, HeaderModel model) {
        DockHeader line = new DockHeader(getPersistentID(), title(), getIcon(), isFoldable(), controller, model);
        header = Optional.of(line);
        return line;
    }
}
