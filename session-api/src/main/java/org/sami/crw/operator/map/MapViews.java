package org.sami.crw.operator.map;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongFunction;
import org.sami.crw.markup.MapRelevance;
import org.sami.crw.markup.MapRelevance.AreaSource;
import org.sami.crw.markup.MapRelevance.MapType;
import org.sami.crw.markup.MapRelevance.Modification;
import org.sami.crw.markup.MarkedEvent;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.GeoPoint;

/**
 * The part of the map that is to be seen (markup Relevant Area). Without a modification it is the relevant part; <i>expand</i> widens what
 * is shown so that it has the part in it, <i>reduce</i> narrows what is shown to the part (docs/operator-models.md). For the owner's thread.
 */
public final class MapViews {
    private final LongFunction<String> missions;
    private Optional<ShownPart> view = Optional.empty();
    private Optional<MapBounds> shown = Optional.empty();
    private long views;

    /**
     * Nobody has asked for a part.
     *
     * @param missions names a mission
     */
    public MapViews(LongFunction<String> missions) {
        this.missions = missions;
    }

    /** A person has moved the map. */
    public void shown(MapBounds now) {
        shown = Optional.of(now);
    }

    /**
     * An event asks for a part.
     *
     * @param boats where the boats are that its markup speaks of
     */
    public void come(MarkedEvent event, MapRelevance.Area area, List<GeoPoint> boats) {
        List<GeoPoint> points = new ArrayList<>(boats);
        if (area.source() == AreaSource.AREA) {
            area.area().ifPresent(one -> points.addAll(one.outline()));
        } else if (area.source() == AreaSource.POINT) {
            area.point().ifPresent(points::add);
        }
        MapBounds.around(points)
                .ifPresent(part -> go(
                        modified(part, area.modification()), area.mapType(), event.mission(), event.words(missions)));
    }

    /** A person asks where boats are: what is shown is widened where they are not in it. */
    public void pointAt(List<GeoPoint> boats, String why) {
        MapBounds.around(boats)
                .filter(part -> shown.filter(now -> now.and(part).equals(now)).isEmpty())
                .ifPresent(part -> go(
                        modified(part, Optional.of(Modification.EXPAND)),
                        view.map(ShownPart::background).orElse(MapType.SATELLITE),
                        Ids.NONE,
                        why));
    }

    private MapBounds modified(MapBounds part, Optional<Modification> modification) {
        if (shown.isEmpty() || modification.isEmpty()) {
            return part;
        }
        return modification.get() == Modification.EXPAND
                ? part.and(shown.get())
                : part.within(shown.get()).orElse(part);
    }

    private void go(MapBounds to, MapType background, long mission, String why) {
        views++;
        shown = Optional.of(to);
        view = Optional.of(new ShownPart(
                views, to.southDeg(), to.westDeg(), to.northDeg(), to.eastDeg(), background, mission, why));
    }

    public Optional<ShownPart> view() {
        return view;
    }
}
