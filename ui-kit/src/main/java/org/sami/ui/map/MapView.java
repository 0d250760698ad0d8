package org.sami.ui.map;

import java.awt.BorderLayout;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JPanel;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.canvas.CanvasKey;
import org.sami.ui.canvas.CanvasMouse;
import org.sami.ui.command.Command;
import org.sami.ui.geo.CoordinateNotation;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.GeoShape;
import org.sami.ui.geo.GeoSketch;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.look.Look;

/**
 * A map: base map or grid, layers, scale, and below it the coordinates under the pointer and a field in which coordinates are typed.
 * It pans by dragging, zooms by the wheel, and does all of it by keys ({@link MapKey}). Points, paths and areas are drawn by
 * {@link #edit}. Lives on the event thread, and waits for nothing.
 */
public final class MapView extends JPanel implements AutoCloseable {
    private static final double PAN_PX = 80;
    private static final int LOW_PX = 240;

    private final MapCanvas canvas = new MapCanvas();
    private final transient MapStatusBar status;
    private final transient BaseMaps base;
    private final transient List<MapListener> listeners = new CopyOnWriteArrayList<>();
    private final transient ChooseTool chooseTool;
    private transient Optional<SketchTool> editing = Optional.empty();
    private transient Optional<SketchTool> measuring = Optional.empty();
    private transient Optional<MapPointer> pointer = Optional.empty();
    private final transient List<Command> commands = CanvasKey.commands(MapKey.values(), this::run, this::whyNot);
    private transient String valueSaid = "-";
    private transient String problemSaid = "-";
    private transient String hint = "";
    private final transient Runnable sketchChanged = this::sketchChanged;

    public MapView() {
        super(new BorderLayout());
        setName("map");
        status = new MapStatusBar(this::press, this::typed, this::copy, this::say);
        base = new BaseMaps(canvas, this::tellProblem, () -> listeners.forEach(MapListener::baseMapsChanged));
        chooseTool = new ChooseTool(
                canvas.layers(),
                click -> {
                    leaveProblem();
                    listeners.forEach(listener -> listener.clicked(click));
                },
                items -> listeners.forEach(listener -> listener.boxed(items)),
                canvas::repaint);
        canvas.setTool(chooseTool);
        canvas.getAccessibleContext().setAccessibleName("Map");
        CanvasMouse.listen(canvas, new MapSurface(canvas, this::pointed));
        canvas.addPropertyChangeListener("center", e -> listeners.forEach(MapListener::moved));
        add(canvas, BorderLayout.CENTER);
        add(status, BorderLayout.SOUTH);
        commands.forEach(command -> command.bindTo(canvas));
    }

    /** What can be done with the map, with the keys that do it while the map has the focus: for the window's registry. */
    public List<Command> commands() {
        return commands;
    }

    /** The command of a key. */
    public Command command(MapKey key) {
        return commands.stream()
                .filter(command -> command.id().equals(key.id()))
                .findFirst()
                .orElseThrow();
    }

    private Optional<String> whyNot(MapKey key) {
        return key.isOfSketch() && drawn().isEmpty() ? Optional.of("nothing is drawn on the map") : Optional.empty();
    }

    private void run(MapKey key) {
        canvas.requestFocusInWindow(); // what comes next is meant for the map, too
        press(key);
    }

    /** The layers, from the lowest to the topmost. */
    public MapLayers layers() {
        return canvas.layers();
    }

    /** Adds somebody who hears what is done on the map. */
    public void addMapListener(MapListener listener) {
        listeners.add(listener);
    }

    /** Which part of the world is shown, in pixels of {@link #canvas}. */
    public MapFrame frame() {
        return canvas.frame();
    }

    /** The component that has the focus when keys are to act on the map. */
    public JComponent canvas() {
        return canvas;
    }

    /** Shows a box as large as it fits. */
    public void fit(GeoBounds box) {
        canvas.fit(box);
    }

    /** Shows all that layers, sketch and base map have; does nothing where they have nothing. */
    public void fitAll() {
        Optional<GeoBounds> shown = layers().bounds(); // base maps are taken only where there is nothing else
        Optional<GeoBounds> drawn =
                editing.flatMap(tool -> GeoBounds.of(tool.sketch().points()));
        Optional<GeoBounds> all = shown.isPresent() && drawn.isPresent()
                ? Optional.of(shown.get().with(drawn.get()))
                : shown.or(() -> drawn).or(canvas::extent);
        all.ifPresent(canvas::fit);
    }

    /** Shows a point in the middle. */
    public void centre(GeoPoint point) {
        canvas.centre(point);
    }

    /** Draws what has one of these ids as ever and everything else dimmed; with no id, all as ever. */
    public void highlight(Set<String> ids) {
        canvas.highlight(ids);
    }

    /**
     * Makes it part of a form, or a panel of its own. In a form there is no room for the line below the map, drawing has no end of its own to speak of, and the
     * wheel scrolls the form, where that can be scrolled, until the map has the focus or Ctrl is held.
     */
    public void setInForm(boolean inForm) {
        status.setVisible(!inForm);
        canvas.setInForm(inForm);
    }

    /** Shows or hides the grid. */
    public void setGrid(boolean shown) {
        canvas.setGrid(shown);
    }

    /** Writes coordinates in this notation. */
    public void setNotation(CoordinateNotation notation) {
        status.setNotation(notation);
    }

    /** How coordinates are written. */
    public CoordinateNotation notation() {
        return status.notation();
    }

    /**
     * Opens a base map off the event thread: raster tiles (.mbtiles), or outlines (.geojson, .json). It becomes a layer below
     * all others. A file that takes its time is named on the map until it is read or left ({@link #stopReading}). What is wrong with
     * the file is shown on the map and reported to listeners.
     */
    public void openBaseMap(Path file) {
        base.open(file);
    }

    /** The base maps, in the order in which they were opened. */
    public List<BaseMapState> baseMaps() {
        return base.states();
    }

    /** A base map that an earlier window had: it stays on the list also where its file cannot be read now. */
    public void restoreBaseMap(Path file, boolean on) {
        base.restore(file, on);
    }

    /** Takes a base map off, or puts it on again; one that was not read yet is read. */
    public void setBaseMap(Path file, boolean on) {
        base.setOn(file, on);
    }

    /**
     * Shows the base maps that another map shows, and no others, without reading their files again; to be called again when the other may
     * show others.
     */
    public void showBaseMapsOf(MapView other) {
        base.showThoseOf(other.base);
    }

    /** Takes a base map off the list. */
    public void forgetBaseMap(Path file) {
        base.forget(file);
    }

    /** The command that leaves a base map which is still being read: for the window's registry. */
    public Command stopReading() {
        return base.stopReading();
    }

    /**
     * Shows a line on the map while no other is shown there, such as what a click does now; behind what a sketch still lacks.
     *
     * @param text empty for none
     */
    public void setHint(String text) {
        if (!text.equals(hint)) {
            boolean shown = canvas.said().equals(hint);
            hint = text;
            if (editing.isPresent()) {
                sketchChanged();
            } else if (shown) {
                say("", false);
            }
        }
    }

    private void say(String text, boolean problem) {
        canvas.say(text.isEmpty() ? hint : text, problem && !text.isEmpty());
    }

    /** The user has read the message about a file: it stays in notices and in the list of base maps. */
    private void leaveProblem() {
        if (canvas.said().equals(problemSaid)) {
            say("", false);
        }
    }

    private void tellProblem(String problem) {
        problemSaid = problem;
        say(problem, true);
        listeners.forEach(listener -> listener.problem(problem));
    }

    /**
     * Lets the operator draw or change something until {@link #stopEditing}, or until somebody ends it.
     *
     * @param ended receives whether what was drawn is kept (Enter, double click) or not (Escape); the map has stopped editing then
     */
    public void edit(GeoSketch sketch, Consumer<Boolean> ended) {
        stopEditing();
        SketchTool tool = new SketchTool(
                sketch,
                false,
                chooseTool,
                canvas::frame,
                () -> {
                    if (sketch.problem().isPresent()) {
                        say(sketch.problem().get(), true);
                    } else {
                        stopEditing();
                        ended.accept(true);
                    }
                },
                () -> {
                    stopEditing();
                    ended.accept(false);
                });
        measuring = Optional.empty();
        editing = Optional.of(tool);
        sketch.addListener(sketchChanged);
        sketchChanged();
        canvas.setTool(tool);
    }

    /** Ends drawing; the sketch stays as it is, and so does a way that is measured. Does nothing where nothing is drawn. */
    public void stopEditing() {
        editing.ifPresent(tool -> tool.sketch().removeListener(sketchChanged));
        if (editing.isPresent()) {
            editing = Optional.empty();
            if (measuring.isEmpty()) {
                say("", false);
                canvas.setTool(chooseTool);
            }
        }
    }

    /** Whether a way is measured, which comes before all else. */
    public boolean isMeasuring() {
        return measuring.isPresent();
    }

    /** Whether something is drawn. */
    public boolean isEditing() {
        return editing.isPresent();
    }

    private void sketchChanged() {
        String ended = canvas.isInForm() ? "" : "Enter or a double click ends, Escape leaves, Ctrl+Z undoes";
        editing.ifPresent(tool -> {
            Optional<String> problem = tool.sketch().problem();
            String words = hint.isEmpty()
                    ? problem.orElse(ended)
                    : problem.map(lacks -> isLow() ? lacks : lacks + " · " + hint)
                            .orElse(hint);
            say(words, false);
        });
        canvas.repaint();
    }

    /** Whether there is room for few words, so that they leave something of the map. */
    private boolean isLow() {
        return canvas.getHeight() < Look.px(LOW_PX);
    }

    /** Measures a way until {@link MapKey#MEASURE} or Escape ends it; what is being drawn waits. */
    private void toggleMeasuring() {
        if (measuring.isPresent()) {
            measuring = Optional.empty();
            canvas.setTool(editing.<MapTool>map(tool -> tool).orElse(chooseTool));
            say("", false);
            return;
        }
        GeoSketch way = new GeoSketch(GeoShape.PATH);
        way.addListener(canvas::repaint);
        SketchTool tool = new SketchTool(way, true, chooseTool, canvas::frame, () -> {}, this::toggleMeasuring);
        measuring = Optional.of(tool);
        canvas.setTool(tool);
        say("Click the points of the way to measure; Escape ends", false);
    }

    /** Does what a key does. */
    public void press(MapKey key) {
        if (canvas.tool().key(key)) {
            canvas.repaint();
            return;
        }
        double x = pointer.map(MapPointer::px).orElse(canvas.getWidth() / 2.0);
        double y = pointer.map(MapPointer::py).orElse(canvas.getHeight() / 2.0);
        switch (key) {
            case LEFT -> canvas.pan(-PAN_PX, 0);
            case RIGHT -> canvas.pan(PAN_PX, 0);
            case UP -> canvas.pan(0, -PAN_PX);
            case DOWN -> canvas.pan(0, PAN_PX);
            case ZOOM_IN -> canvas.zoom(1, x, y);
            case ZOOM_OUT -> canvas.zoom(-1, x, y);
            case FIT -> fitAll();
            case MEASURE -> toggleMeasuring();
            case COPY -> copy();
            case TYPE -> status.type();
            case ADD -> drawn().ifPresent(sketch -> sketch.add(canvas.frame().point(x, y)));
            default -> {}
        }
    }

    private Optional<GeoSketch> drawn() {
        return measuring.or(() -> editing).map(SketchTool::sketch);
    }

    /** A point was typed: it becomes part of what is drawn, else the map goes there. */
    private void typed(GeoPoint point) {
        drawn().ifPresent(sketch -> sketch.add(point));
        if (!canvas.frame().isShown(point)) {
            canvas.centre(point);
        }
        canvas.requestFocusInWindow();
    }

    private void pointed(Optional<MapPointer> at) {
        pointer = at;
        status.point(at.map(MapPointer::at));
        Optional<String> text = at.flatMap(p -> layers().textAt(p.frame(), p.px(), p.py()));
        if (text.isPresent() || canvas.said().equals(valueSaid)) {
            valueSaid = text.orElse("");
            say(valueSaid, false);
        }
    }

    private void copy() {
        pointer.map(MapPointer::at).or(status::last).ifPresent(at -> {
            String text = status.notation().format(at);
            Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(text), null);
            say("Copied " + text, false);
        });
    }

    /** Closes base map files; the map is used no more. */
    @Override
    public void close() {
        base.end();
    }
}
