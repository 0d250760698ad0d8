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

/** An area that boats explored from a time on. Its coverage is measured for the planned, the reported and the true tracks. */
final class ExplorationRequest {
    /** Smaller pieces are left out of the map, not of the sum. */
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

    /** Records how the area was divided, if an input says so: the first division, since later ones divide the rest. */
    void hear(Input input) {
        if (planned.isEmpty()) {
            planned = ExplorationShares.of(input, area, spacingM).map(shares -> shares.values());
        }
    }

    /**
     * The result of the exploration.
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

    /** The coverage of sets of tracks, computed in parallel: each takes as long as some hundred simulated seconds. */
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
