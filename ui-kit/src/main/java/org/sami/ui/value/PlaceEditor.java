package org.sami.ui.value;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.IdentityMark;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;
import org.sami.ui.geo.GeoShape;
import org.sami.ui.geo.GeoSketch;
import org.sami.ui.look.FoldingPanel;
import org.sami.ui.look.Look;
import org.sami.ui.map.MapView;

/**
 * A point, list of points, path or area, drawn on a map of its own or entered as coordinates next to it, or below it where the panel is narrow:
 * each follows the other. What stands in the text is the value (component {@code Map}).
 */
final class PlaceEditor extends ValueEditor {
    private static final int ROOM = 520;
    private static final String LAYOUT = "novisualpadding, insets 0, gap 8 4, fill, hidemode 3";
    private static final double PER_DEGREE = 1e7; // about 1 cm: what a pointer says beyond that is noise

    private final GeoSketch sketch;
    private final TextEditor text;
    private static final int LEAST = 130;

    private final MapView map;
    private final MapMaker maps;
    private final JPanel mapSide = new JPanel(new BorderLayout());
    private final MigLayout layout = new MigLayout(LAYOUT + ", wrap 1", "[grow,fill]", "[grow,fill][]");
    private final FoldingPanel panel = new FoldingPanel(layout);
    private final PlacesOnMap places;
    private boolean editable = true;
    private boolean following;
    private List<GeoPoint> drawn = List.of();

    PlaceEditor(ValueField field, GeoShape shape, PlacesText form, MapMaker maps) {
        super(field);
        this.maps = maps;
        this.map = maps.make();
        sketch = new GeoSketch(shape);
        text = new TextEditor(field, form);
        panel.setOpaque(false);
        map.setName(field.componentName("map"));
        map.canvas().setName(field.componentName("canvas"));
        map.setInForm(true);
        MapResizeBar grip = new MapResizeBar(map::getHeight, this::resize);
        grip.setName(field.componentName("map-height"));
        mapSide.setOpaque(false);
        mapSide.add(map);
        mapSide.add(grip, BorderLayout.SOUTH);
        panel.foldWhere(() -> map.isVisible() && panel.getWidth() >= Look.px(ROOM), this::putInOneRow);
        panel.add(mapSide, high(maps.height()));
        panel.add(text.component(), "wmin 120, aligny top");
        places = new PlacesOnMap(map, field.componentName("places"), robot -> new IdentityMark(0));
        sketch.addListener(this::drew);
        text.addListener(this::typed);
        draw();
    }

    /** Puts the text next to the map where both have room, so that it is visible in a low panel. */
    private void putInOneRow(boolean room) {
        layout.setLayoutConstraints(LAYOUT + (room ? "" : ", wrap 1"));
        layout.setColumnConstraints(room ? "[60%,fill][grow,fill]" : "[grow,fill]");
        layout.setRowConstraints(room ? "[grow,fill]" : "[grow,fill][]");
        panel.invalidate();
    }

    private static String high(int height) {
        return "h " + LEAST + ":" + height + ":, wmin 120, grow";
    }

    /** Makes the map so many pixels high, and those that come after it. */
    private void resize(int height) {
        int now = Math.max(LEAST, Math.round(height * 100f / Look.scalePercent()));
        maps.keepHeight(now);
        layout.setComponentConstraints(mapSide, high(now));
        panel.revalidate();
    }

    @Override
    void leaveMessage() {
        text.leaveMessage();
    }

    /** Drawing never ends by itself: a form is left by other means. */
    private void draw() {
        map.edit(sketch, kept -> draw());
    }

    private void drew() {
        if (!following && !sketch.points().equals(drawn)) {
            drawn = sketch.points();
            follow(() -> text.type(
                    PlacesText.write(drawn.stream().map(PlaceEditor::rounded).toList(), sketch.holes())));
            bringIntoSight();
            changed();
        }
    }

    private void typed() {
        if (!following) {
            Entry entry = text.entry();
            if (entry instanceof Entry.Given given) {
                follow(() -> sketch.show(given.given()));
            } else if (entry instanceof Entry.Missing missing && !missing.wrong()) {
                follow(sketch::clear);
            }
            drawn = sketch.points();
            changed();
        }
    }

    /** What was drawn on another map is seen on this one, which stays where it is while somebody draws on it or types. */
    private void bringIntoSight() {
        boolean outside = drawn.stream().anyMatch(point -> !map.frame().isShown(point));
        if (outside && !map.canvas().isFocusOwner()) {
            map.fitAll();
        }
    }

    /** Lets one side follow the other, without an answer. */
    private void follow(Runnable change) {
        following = true;
        try {
            change.run();
        } finally {
            following = false;
        }
    }

    private static GeoPoint rounded(GeoPoint point) {
        return new GeoPoint(
                Math.round(point.latDeg() * PER_DEGREE) / PER_DEGREE,
                Math.round(point.lonDeg() * PER_DEGREE) / PER_DEGREE,
                point.altM());
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public JComponent focusTarget() {
        return map.isVisible() ? map.canvas() : text.focusTarget();
    }

    @Override
    public void useOwnMap(boolean shown) {
        if (map.isVisible() != shown) {
            map.setVisible(shown);
            mapSide.setVisible(shown);
            panel.revalidate();
            if (shown) {
                map.fitAll();
            }
        }
    }

    @Override
    public Optional<GeoSketch> sketch() {
        return editable ? Optional.of(sketch) : Optional.empty();
    }

    @Override
    public Entry entry() {
        return text.entry();
    }

    @Override
    protected void display(Value value) {
        follow(() -> {
            text.show(value);
            sketch.show(value);
        });
        drawn = sketch.points();
        showPlaces();
        map.fitAll();
    }

    @Override
    protected void displayNothing() {
        follow(() -> {
            text.clear();
            sketch.clear();
        });
        drawn = sketch.points();
    }

    /** What is only looked at is drawn as other places are, without corners to take hold of. */
    private void showPlaces() {
        places.show(editable ? List.of() : sketch.value().stream().toList());
    }

    @Override
    public void setEditable(boolean editable) {
        this.editable = editable;
        text.setEditable(editable);
        if (editable) {
            draw();
        } else {
            map.stopEditing();
        }
        showPlaces();
    }
}
