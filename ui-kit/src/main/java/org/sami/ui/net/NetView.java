package org.sami.ui.net;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JPanel;
import org.jspecify.annotations.Nullable;
import org.sami.palette.ProxyMarks;
import org.sami.picture.GraphicsCanvas;
import org.sami.picture.NetFonts;
import org.sami.picture.net.NetBadges;
import org.sami.picture.net.NetChange;
import org.sami.picture.net.NetFigure;
import org.sami.picture.net.NetLight;
import org.sami.picture.net.NetMarking;
import org.sami.picture.net.NetMode;
import org.sami.picture.net.NetPainter;
import org.sami.picture.net.NetScene;
import org.sami.picture.net.NetSight;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Token;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.ui.canvas.CanvasKey;
import org.sami.ui.canvas.CanvasMouse;
import org.sami.ui.command.Command;
import org.sami.ui.look.Look;

/**
 * The net of a plan: where its author has laid it out, with tokens, firing, selection, tooltips and an overview in its corner. It pans
 * by dragging, zooms by the wheel, and does all of it by keys ({@link NetKey}). An editor gives it tools ({@link NetTool}). Lives on the
 * event thread.
 */
public final class NetView extends JPanel {
    private static final int CORNER_PX = 8;

    private final transient ProxyMarks marks;
    private final NetViewer viewer = new NetViewer(this::paintNet, this::tip);
    private final transient NetViewport viewport = new NetViewport(viewer, this::viewChanged);
    private final transient NetPulse pulse = new NetPulse(System::nanoTime, viewer::repaint);
    private final NetOverview overview = new NetOverview(this, viewport);
    private final transient NetNavigation navigation = new NetNavigation(this, viewport, overview);
    private final transient List<NetListener> listeners = new CopyOnWriteArrayList<>();
    private transient NetContent content = NetContent.NONE;
    private transient NetMarking marking = NetMarking.EMPTY;
    private transient NetBadges badges = NetBadges.NONE;
    private transient NetMode mode = NetMode.NOMINAL;
    private transient Set<String> selected = Set.of();
    private transient Set<String> highlighted = Set.of();
    private transient Map<String, NetChange> changes = Map.of();
    private transient NetScene scene = content.scene(mode, selected);
    private transient NetTool tool = new NetSelectTool(this);
    private final transient NetTooltip tooltip = new NetTooltip();

    /**
     * Makes a view that shows nothing yet.
     *
     * @param marks which colour and shape stand for each proxy
     */
    public NetView(ProxyMarks marks) {
        super(null);
        setName("net");
        this.marks = marks;
        CanvasMouse.listen(viewer, new NetSurface(this, viewport));
        viewer.getAccessibleContext().setAccessibleName("Net");
        add(overview);
        add(viewer);
        commands(() -> Optional.of(this)).forEach(command -> command.bindTo(viewer));
    }

    /**
     * The commands of the net that a window shows at the moment, for the window's registry; the view has its keys without that.
     *
     * @param shown the net that they act on; none where no net is shown
     */
    public static List<Command> commands(Supplier<Optional<NetView>> shown) {
        return CanvasKey.commands(
                NetKey.values(),
                key -> shown.get().ifPresent(view -> view.press(key)),
                key -> shown.get().isPresent() ? Optional.empty() : Optional.of("no net is shown"));
    }

    /** Shows a plan where its author has laid it out, in layers where it does not say so of each vertex. */
    public void show(Plan plan, Vocabulary vocabulary) {
        show(plan, vocabulary, NetLayout.given(plan, vocabulary, NetFonts::width));
    }

    /** Shows a plan in layers from left to right; its own layout stays as it is. */
    public void showLayered(Plan plan, Vocabulary vocabulary) {
        show(plan, vocabulary, NetLayout.layered(plan, vocabulary, NetFonts::width));
        fit();
    }

    /**
     * Shows a plan as it was drawn elsewhere, such as off the event thread. Another version of the plan that is shown keeps view
     * and selection.
     */
    public void show(Plan plan, Vocabulary vocabulary, NetDrawing drawing) {
        boolean another = !plan.id().equals(content.plan().id());
        content = new NetContent(plan, vocabulary, drawing);
        if (another) {
            marking = NetMarking.EMPTY;
            badges = NetBadges.NONE;
            selected = Set.of();
            highlighted = Set.of();
        }
        changed();
        if (another) {
            navigation.begin();
        }
    }

    /** Shows the same plan with its elements elsewhere, while they are dragged. */
    public void preview(NetDrawing drawing) {
        content = new NetContent(content.plan(), content.vocabulary(), drawing);
        changed();
    }

    /** Marks how elements differ from another version of the plan, by their ids. */
    public void setChanges(Map<String, NetChange> changes) {
        this.changes = Map.copyOf(changes);
        viewer.repaint();
    }

    private void changed() {
        scene = content.scene(mode, selected);
        viewer.repaint();
        overview.repaint();
    }

    /** Shows what stands where. */
    public void setMarking(NetMarking marking) {
        NetMarking before = this.marking;
        this.marking = marking;
        navigation.follow(before);
        viewer.repaint();
        overview.repaint();
    }

    /** Shows signs at vertices. */
    public void setBadges(NetBadges badges) {
        this.badges = badges;
        viewer.repaint();
    }

    /** What stands where. */
    public NetMarking marking() {
        return marking;
    }

    /** Lets a transition shine for a quarter of a second, unless that is turned off. */
    public void fired(String transition) {
        pulse.fired(transition);
        viewer.repaint();
    }

    /** Turns the shining of transitions that fire on or off. */
    public void setPulse(boolean on) {
        pulse.setOn(on);
    }

    /** Shows nominal parts, recovery parts or all. */
    public void setMode(NetMode mode) {
        this.mode = mode;
        changed();
    }

    /** How much is shown. */
    public NetMode mode() {
        return mode;
    }

    /** Selects vertices and edges instead of those before, by their ids. */
    public void select(Set<String> ids) {
        if (!selected.equals(ids)) {
            selected = Collections.unmodifiableSet(new LinkedHashSet<>(ids)); // in the order of their selection
            changed();
            listeners.forEach(listener -> listener.selected(selected));
        }
    }

    /** What is selected. */
    public Set<String> selected() {
        return selected;
    }

    /** Marks what somebody speaks of, such as a finding, and shows it. */
    public void highlight(Set<String> ids) {
        highlighted = Set.copyOf(ids);
        navigation.centreFirst(ids);
        viewer.repaint();
    }

    /** Asks somebody for one more line in tooltips: why a transition does not fire, by its id. */
    public void setExplanation(Function<String, Optional<String>> explanation) {
        tooltip.setExplanation(explanation);
    }

    /** Asks somebody for what people call a token. */
    public void setTokenName(Function<Token, String> tokenName) {
        tooltip.setTokenName(tokenName);
    }

    /** Gives the pointer another meaning. */
    public void setTool(NetTool tool) {
        this.tool = tool;
        viewer.repaint();
    }

    NetTool tool() {
        return tool;
    }

    /** What is shown. */
    public NetScene scene() {
        return scene;
    }

    /** Where it lies. */
    public NetDrawing drawing() {
        return content.drawing();
    }

    /** The component that has the focus when keys are to act on the net. */
    public JComponent canvas() {
        return viewer;
    }

    /** Adds somebody who hears what is done with the net. */
    public void addNetListener(NetListener listener) {
        listeners.add(listener);
    }

    void tellOpened(String id) {
        listeners.forEach(listener -> listener.opened(id));
    }

    void tellMenu(String id, int x, int y) {
        listeners.forEach(listener -> listener.menu(id, x, y));
    }

    /** Shows all that the mode shows, not larger than its own size. */
    public void fit() {
        navigation.fit();
    }

    /**
     * Has the view keep tokens in sight: it begins no smaller than words are read at, and shows places to which tokens come with room
     * around them, until somebody moves it by hand; it follows again when all of the net has been shown ({@link NetKey#FIT}). For whoever
     * watches a mission; an author's view stays where the author put it.
     */
    public void setFollowing(boolean following) {
        navigation.setFollowing(following);
    }

    /**
     * Brings vertices into sight, moving the view no more than needed and making nothing smaller. Where they do not fit, their middle is
     * shown; those that the mode hides are left alone.
     */
    public void reveal(Set<String> ids) {
        navigation.reveal(ids);
    }

    /**
     * Shows vertices and notes with their words in the middle, smaller only where they do not fit otherwise. Nothing moves where all of
     * them is seen already; what the mode hides is left alone.
     */
    public void revealWhole(Set<String> ids) {
        navigation.revealWhole(ids);
    }

    /** Shows vertices in the middle, larger where their words are too small to be read; what the mode hides is left alone. */
    public void revealReadable(Set<String> ids) {
        navigation.revealReadable(ids);
    }

    /** Shows the overview in the lower right corner while not all of the net is seen, or never. */
    public void setOverview(boolean shown) {
        overview.setEnabledByUser(shown);
    }

    void toggleOverview() {
        setOverview(!overview.isEnabledByUser());
    }

    /** Where a point of the drawing is, in pixels of {@link #canvas}. */
    public Point2D pixel(double x, double y) {
        return viewport.pixel(x, y);
    }

    /** The point of the drawing in the middle of the view. */
    public LayoutPoint centre() {
        return point(viewer.getWidth() / 2.0, viewer.getHeight() / 2.0);
    }

    /** The point of the drawing at a pixel of {@link #canvas}. */
    public LayoutPoint point(double px, double py) {
        Point2D at = viewport.point(px, py);
        return new LayoutPoint(at.getX(), at.getY());
    }

    /** How large the net is shown: 1 at its own size. */
    public double zoom() {
        return viewport.zoom();
    }

    /** Does what a key does. */
    public void press(NetKey key) {
        navigation.press(key);
    }

    private void viewChanged() {
        overview.refresh();
    }

    private void paintNet(Graphics2D g, double scale) {
        NetLight light = new NetLight(selected, highlighted, pulse::of, changes);
        Rectangle2D clip = g.getClip().getBounds2D();
        NetPainter.paint(
                new GraphicsCanvas(g),
                Look.theme(),
                marks,
                new NetFigure(scene, marking, badges, light),
                new NetSight(
                        new DrawingBox(clip.getX(), clip.getY(), clip.getWidth(), clip.getHeight()),
                        scale,
                        viewport.own()));
        tool.paint(g);
    }

    private @Nullable String tip(MouseEvent e) {
        return tooltip.at(viewport.point(e.getX(), e.getY()), scene, content, marking)
                .orElse(null);
    }

    @Override
    public void doLayout() {
        viewer.setBounds(0, 0, getWidth(), getHeight());
        Dimension size = overview.getPreferredSize();
        overview.setBounds(
                getWidth() - size.width - CORNER_PX, getHeight() - size.height - CORNER_PX, size.width, size.height);
        navigation.laidOut();
        overview.refresh();
    }

    @Override
    public Dimension getPreferredSize() {
        return viewer.getPreferredSize();
    }
}
