package org.sami.crw.gui.map;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.gui.decision.DecisionMap;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.Value;
import org.sami.ui.look.IdentityMark;
import org.sami.ui.look.IdentityMarks;
import org.sami.ui.map.AreaLayer;
import org.sami.ui.map.MapView;
import org.sami.ui.map.PathLayer;
import org.sami.ui.map.PlannedPath;
import org.sami.ui.map.PointLayer;
import org.sami.ui.map.ShownArea;

/** What the shown decision speaks of, on the main map: its boats stand out, and what is chosen or filled in is drawn above all else. */
final class DecisionOverlay implements DecisionMap {
    private static final String ID = "decision-";
    private static final IdentityMark NOBODY = new IdentityMark(0);

    private final MapView view;
    private final IdentityMarks marks;
    private final AreaLayer areas = new AreaLayer("decision-areas", "Areas of the decision");
    private final PathLayer paths = new PathLayer("decision-paths", "Paths of the decision");
    private final PointLayer points = new PointLayer("decision-points", "Points of the decision");
    private final List<ShownArea> shownAreas = new ArrayList<>();
    private final List<PlannedPath> shownPaths = new ArrayList<>();
    private final List<PointLayer.MapPoint> shownPoints = new ArrayList<>();
    private final Set<String> lit = new HashSet<>();

    DecisionOverlay(MapView view, IdentityMarks marks) {
        this.view = view;
        this.marks = marks;
        List.of(areas, paths, points).forEach(view.layers()::add);
    }

    @Override
    public void show(DecisionPresentation decision, List<Value> values) {
        forget();
        if (decision.question() instanceof Question.ChooseProxies asked) {
            lit.addAll(asked.proxies());
        }
        decision.map().boats().ifPresent(boats -> lit.addAll(boats.boats()));
        values.forEach(value -> draw("", value));
        paint();
    }

    @Override
    public void clear() {
        forget();
        paint();
    }

    private void forget() {
        List.of(shownAreas, shownPaths, shownPoints).forEach(List::clear);
        lit.clear();
    }

    private void paint() {
        areas.show(List.copyOf(shownAreas));
        paths.show(List.copyOf(shownPaths));
        points.show(List.copyOf(shownPoints));
        view.highlight(Set.copyOf(lit));
    }

    /** Draws what of a value has a place. */
    private void draw(String boat, Value value) {
        String id = ID + (shownAreas.size() + shownPaths.size() + shownPoints.size());
        if (value instanceof GeoPoint point) {
            shownPoints.add(new PointLayer.MapPoint(id, String.valueOf(shownPoints.size() + 1), point));
        } else if (value instanceof GeoPath path) {
            shownPaths.add(new PlannedPath(id, boat.isEmpty() ? NOBODY : marks.of(boat), path.points(), 0));
        } else if (value instanceof GeoArea area) {
            shownAreas.add(new ShownArea(id, "", area, ShownArea.Kind.WORK));
        } else if (value instanceof ProxyValue proxy) {
            lit.add(proxy.proxy());
            return;
        } else if (value instanceof ListValue list) {
            list.items().forEach(item -> draw(boat, item));
            return;
        } else if (value instanceof RecordValue fields) {
            fields.fields().values().forEach(part -> draw(boat, part));
            return;
        } else if (value instanceof MapValue map) {
            map.entries().forEach(this::drawEntry);
            return;
        } else {
            return;
        }
        lit.add(id);
    }

    private void drawEntry(Value key, Value value) {
        if (key instanceof ProxyValue proxy) {
            lit.add(proxy.proxy());
            draw(proxy.proxy(), value);
        } else {
            draw("", value);
        }
    }
}
