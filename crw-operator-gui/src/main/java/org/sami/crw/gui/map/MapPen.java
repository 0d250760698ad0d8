package org.sami.crw.gui.map;

import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import org.sami.crw.gui.decision.BoatPick;
import org.sami.crw.gui.decision.DecisionMap.PenEnd;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoSketch;
import org.sami.ui.map.MapClick;
import org.sami.ui.map.MapView;
import org.sami.ui.map.PickLayer;

/** The pen on the large map: draws a sketch, or chooses boats by clicks and boxes. It never comes between what else is done there. On the event thread. */
final class MapPen {
    private static final long REST_NANOS = 700_000_000L;

    private final MapView view;
    private final BooleanSupplier busy;
    private final Function<String, Optional<GeoPoint>> places;
    private final PickLayer picked;
    private Optional<Consumer<PenEnd>> out = Optional.empty();
    private Optional<BoatPick> pick = Optional.empty();
    private boolean pressed;
    private long usedNanos = System.nanoTime() - REST_NANOS;

    /**
     * A pen that is not out.
     *
     * @param busy whether the map waits for a click that is meant for something else
     * @param places where robots are shown
     * @param words puts their word into a text about boats
     */
    MapPen(
            MapView view,
            BooleanSupplier busy,
            Function<String, Optional<GeoPoint>> places,
            UnaryOperator<String> words) {
        this.view = view;
        this.busy = busy;
        this.places = places;
        picked = view.layers()
                .add(new PickLayer("decision-picked", words.apply("Boats that are chosen for the answer")));
        view.canvas().addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                pressed = true;
            }

            @Override
            public void mouseReleased(MouseEvent e) {
                pressed = false;
                usedNanos = System.nanoTime();
            }
        });
    }

    /** Whether the map is used for nothing else now, nor was a moment ago. */
    boolean isFree() {
        return !pressed
                && System.nanoTime() - usedNanos > REST_NANOS
                && !busy.getAsBoolean()
                && !view.isMeasuring()
                && !view.isEditing();
    }

    void draw(GeoSketch sketch, Consumer<PenEnd> ended) {
        putDown();
        out = Optional.of(ended);
        view.edit(sketch, kept -> end(kept ? PenEnd.DONE : PenEnd.PUT_DOWN));
    }

    void pick(BoatPick boats, Consumer<PenEnd> ended) {
        putDown();
        out = Optional.of(ended);
        pick = Optional.of(boats);
        refresh();
    }

    private void end(PenEnd end) {
        Optional<Consumer<PenEnd>> told = out;
        putDown();
        told.ifPresent(one -> one.accept(end));
    }

    /** Puts it down without a notification. */
    void putDown() {
        boolean drawing = out.isPresent() && pick.isEmpty();
        out = Optional.empty();
        pick = Optional.empty();
        if (drawing) {
            view.stopEditing();
        }
        refresh();
    }

    /** Puts it down on the operator's request. Returns whether it was out. */
    boolean escape() {
        boolean was = out.isPresent();
        if (was) {
            end(PenEnd.PUT_DOWN);
        }
        return was;
    }

    /** Something else begins on the map. */
    void interrupt() {
        if (out.isPresent()) {
            end(PenEnd.INTERRUPTED);
        }
    }

    /** Takes a click on a boat that is offered; false where the click is meant for something else. */
    boolean takes(MapClick click) {
        Optional<String> boat = click.item()
                .filter(item -> pick.map(BoatPick::offered).orElse(List.of()).contains(item));
        boat.ifPresent(one -> {
            pick.get().toggle(one);
            refresh();
        });
        return boat.isPresent();
    }

    /** Takes a box around boats that are offered, likewise. */
    boolean takes(List<String> boxed) {
        List<String> boats = boxed.stream()
                .filter(item -> pick.map(BoatPick::offered).orElse(List.of()).contains(item))
                .toList();
        if (!boats.isEmpty()) {
            pick.get().only(boats);
            refresh();
        }
        return !boats.isEmpty();
    }

    /** Marks the boats that are chosen where they are now. */
    void refresh() {
        picked.show(pick.map(BoatPick::chosen).orElse(List.of()).stream()
                .flatMap(boat -> places.apply(boat).stream())
                .toList());
    }

    /** Has Escape do something while the focus is in a component, where nothing in it wants the key. */
    static void onEscape(JComponent component, Runnable run) {
        component
                .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                .put(KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0), "escape");
        component.getActionMap().put("escape", new AbstractAction("escape") {
            @Override
            public void actionPerformed(ActionEvent event) {
                run.run();
            }
        });
    }
}
