package org.sami.crw.gui.map;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.DoubtedPaths;
import org.sami.crw.gui.context.SessionWays;
import org.sami.crw.gui.decision.BoatPick;
import org.sami.crw.gui.decision.DecisionMap;
import org.sami.crw.operator.map.PlacesInText;
import org.sami.crw.operator.map.TaskWays;
import org.sami.palette.ProxyMarks;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.ui.geo.GeoSketch;
import org.sami.ui.map.MapView;
import org.sami.ui.value.PlacesOnMap;

/**
 * What the shown decision speaks of, on the main map: the boats that it is about stand out, what is to be approved, chosen or filled in is drawn above
 * all else, and the places that the question names are marked.
 */
final class DecisionOverlay implements DecisionMap {
    private final MapView view;
    private final SessionWays ways;
    private final PlacesOnMap places;
    private final NamedPlaces named;
    private final MapPen pen;
    private final UnaryOperator<String> words;
    private Optional<GeoSketch> drawn = Optional.empty();
    private long shownFor;
    private final Map<TaskId, GeoPoint> taskPlaces = new HashMap<>();
    private final Runnable fitAll;
    private Optional<DoubtedPaths> doubted = Optional.empty();

    /**
     * Adds its layers to a map.
     *
     * @param pen with which decisions are answered on the map
     * @param ways of boats: the paths of an option are drawn as they would be driven
     * @param fitAll shows all that is on the map
     * @param words puts the word for the session's robots into a text about boats
     */
    DecisionOverlay(
            MapView view,
            ProxyMarks marks,
            SessionWays ways,
            MapPen pen,
            Runnable fitAll,
            UnaryOperator<String> words) {
        this.fitAll = fitAll;
        this.view = view;
        this.pen = pen;
        this.ways = ways;
        this.words = words;
        places = new PlacesOnMap(view, "decision", marks::of);
        named = new NamedPlaces(view, "question");
    }

    @Override
    public void show(DecisionPresentation decision, List<Value> values) {
        boolean other = shownFor != decision.id();
        if (other) {
            doubted = Optional.empty();
        }
        shownFor = decision.id();
        if (doubted.isEmpty()) {
            ways.doubted(decision.decision())
                    .thenAccept(found -> found.filter(paths -> shownFor == decision.id())
                            .ifPresent(paths -> {
                                doubted = found;
                                draw(decision, values);
                            }));
        }
        if (other) {
            taskPlaces.clear();
        }
        Set<TaskId> tasks = values.stream()
                .flatMap(value -> TaskWays.tasks(value).stream())
                .filter(task -> !taskPlaces.containsKey(task))
                .collect(Collectors.toSet());
        draw(decision, values);
        if (!tasks.isEmpty()) {
            ways.places(tasks).thenAccept(found -> {
                if (shownFor == decision.id() && !found.isEmpty()) {
                    taskPlaces.putAll(found);
                    draw(decision, values);
                    fit();
                }
            });
        } else if (other) {
            fit(); // once: who moves the map then wants it elsewhere
        }
    }

    private void fit() {
        if (pen.isFree() && !places.isInSight()) {
            fitAll.run();
        }
    }

    private void draw(DecisionPresentation decision, List<Value> values) {
        places.show(
                doubted.map(DecisionOverlay::value).map(List::of).orElseGet(() -> shown(decision, values)),
                ways.of(doubted.map(DoubtedPaths::mission)
                        .orElse(decision.decision().mission())));
        String prompt = decision.decision().prompt();
        Set<String> here = named.show(PlacesInText.of(prompt));
        Set<String> lit = new HashSet<>(places.ids());
        lit.addAll(BoatsOfDecision.of(decision, doubted));
        if (decision.question() instanceof Question.ChooseProxies asked) {
            lit.addAll(asked.proxies());
        }
        decision.map().boats().ifPresent(boats -> lit.addAll(boats.boats()));
        if (!lit.isEmpty()) {
            lit.addAll(here); // a place alone dims nothing
        }
        view.highlight(lit);
    }

    private List<Value> shown(DecisionPresentation decision, List<Value> values) {
        List<Value> all = new ArrayList<>(decision.approved());
        all.addAll(drawn.isPresent() ? List.of() : values);
        all.replaceAll(value -> TaskWays.of(value, taskPlaces));
        return all;
    }

    private static Value value(DoubtedPaths paths) {
        Map<Value, Value> byBoat = new LinkedHashMap<>();
        paths.byBoat().forEach((boat, path) -> byBoat.put(new ProxyValue(boat), path));
        return new MapValue(byBoat);
    }

    @Override
    public void clear() {
        shownFor = 0;
        doubted = Optional.empty();
        places.show(List.of());
        named.show(List.of());
        view.highlight(Set.of());
    }

    @Override
    public boolean isSeen() {
        return view.isShowing();
    }

    @Override
    public boolean isFree() {
        return pen.isFree();
    }

    @Override
    public void draw(GeoSketch sketch, Consumer<PenEnd> ended) {
        drawn = Optional.of(sketch);
        places.show(List.of());
        pen.draw(sketch, end -> {
            drawn = Optional.empty();
            ended.accept(end);
        });
        if (sketch.points().stream().anyMatch(point -> !view.frame().isShown(point))) {
            fitAll.run();
        }
    }

    @Override
    public void pick(BoatPick boats, Consumer<PenEnd> ended) {
        pen.pick(boats, ended);
    }

    @Override
    public void putDown() {
        drawn = Optional.empty();
        pen.putDown();
    }

    @Override
    public void focus() {
        view.canvas().requestFocusInWindow();
    }

    @Override
    public void say(String text) {
        view.setHint(words.apply(text));
    }
}
