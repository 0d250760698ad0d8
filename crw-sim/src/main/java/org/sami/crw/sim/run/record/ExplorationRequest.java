package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.sami.crw.handler.planning.ExplorationShares;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.Exploration;
import org.sami.crw.report.MapArea;
import org.sami.crw.service.coverage.AreaCoverage;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/** An area that boats were to explore from a time on: measured are the tracks that they were given, that they reported and that they truly drove. */
final class ExplorationRequest {
    /** Smaller pieces are left out of the map; their sum is not. */
    private static final double NEGLIGIBLE_AREA_M2 = 1;

    private final long askedAtMillis;
    private final double spacingM;
    private final GeoArea area;
    private final AreaCoverage coverage;
    private Optional<Collection<GeoPath>> planned = Optional.empty();

    /**
     * A request at a time of the run.
     *
     * @throws IllegalArgumentException for areas that are no simple polygons: boats do not explore those
     */
    ExplorationRequest(
            long askedAtMillis, double spacingM, GeoArea area, List<GeoArea> avoided, Optional<GeoArea> within) {
        this.askedAtMillis = askedAtMillis;
        this.spacingM = spacingM;
        this.area = area;
        coverage = AreaCoverage.of(area, spacingM, avoided, within);
    }

    /** Takes down how the area was divided, if an input says so: the first division, as later ones are of what is left. */
    void hear(Input input) {
        if (planned.isEmpty()) {
            planned = ExplorationShares.of(input, area, spacingM).map(shares -> shares.values());
        }
    }

    /**
     * What became of it.
     *
     * @param piece makes an area of the map of what is left somewhere
     */
    Exploration result(KnownTracks tracks, Function<GeoArea, MapArea> piece) {
        Optional<List<BoatResult>> elsewhere = tracks.truly().filter(boats -> !boats.equals(tracks.reported()));
        List<Optional<AreaCoverage.Left>> left = left(List.of(
                planned.map(ExplorationRequest::points),
                Optional.of(since(tracks.reported())),
                elsewhere.map(this::since)));
        AreaCoverage.Left reported = left.get(1).orElseThrow();
        Optional<AreaCoverage.Left> truly =
                tracks.truly().map(boats -> left.get(2).orElse(reported));
        List<MapArea> uncovered = truly.orElse(reported).parts().stream()
                .filter(part -> AreaCoverage.of(part, spacingM, List.of(), Optional.empty())
                                .areaM2()
                        >= NEGLIGIBLE_AREA_M2)
                .map(piece)
                .toList();
        return new Exploration(
                askedAtMillis,
                spacingM,
                coverage.areaM2(),
                new Exploration.Left(
                        left.get(0).map(AreaCoverage.Left::areaM2),
                        Optional.of(reported.areaM2()),
                        truly.map(AreaCoverage.Left::areaM2)),
                uncovered);
    }

    /** What sets of tracks leave, computed side by side: each takes as long as some hundred simulated seconds. */
    private List<Optional<AreaCoverage.Left>> left(List<Optional<List<List<GeoPoint>>>> sets) {
        return sets.parallelStream().map(set -> set.map(coverage::left)).toList();
    }

    private static List<List<GeoPoint>> points(Collection<GeoPath> paths) {
        return paths.stream().map(GeoPath::points).toList();
    }

    private List<List<GeoPoint>> since(List<BoatResult> boats) {
        List<List<GeoPoint>> tracks = new ArrayList<>();
        for (BoatResult boat : boats) {
            tracks.add(boat.track().stream()
                    .filter(point -> point.atMillis() >= askedAtMillis)
                    .map(point -> GeoPoint.of(point.latDeg(), point.lonDeg()))
                    .toList());
        }
        return tracks;
    }
}
