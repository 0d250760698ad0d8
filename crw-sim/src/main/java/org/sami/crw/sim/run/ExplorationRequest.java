package org.sami.crw.sim.run;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.sami.crw.handler.ExplorationShares;
import org.sami.crw.service.coverage.AreaCoverage;
import org.sami.crw.sim.report.BoatResult;
import org.sami.crw.sim.report.Exploration;
import org.sami.crw.sim.report.MapArea;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/** An area that boats were to explore from a time on: measured are the tracks that they were given, that they reported and that they truly drove. */
final class ExplorationRequest {
    /** Smaller pieces are left out of the map; their sum is not. */
    private static final double CRUMB_M2 = 1;

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
        AreaCoverage.Left reported = coverage.left(since(tracks.reported()));
        Optional<AreaCoverage.Left> truly =
                tracks.truly().map(boats -> boats.equals(tracks.reported()) ? reported : coverage.left(since(boats)));
        List<MapArea> uncovered = truly.orElse(reported).parts().stream()
                .filter(part -> AreaCoverage.of(part, spacingM, List.of(), Optional.empty())
                                .areaM2()
                        >= CRUMB_M2)
                .map(piece)
                .toList();
        return new Exploration(
                askedAtMillis,
                spacingM,
                coverage.areaM2(),
                new Exploration.Left(
                        planned.map(paths -> coverage.left(
                                        paths.stream().map(GeoPath::points).toList())
                                .areaM2()),
                        Optional.of(reported.areaM2()),
                        truly.map(AreaCoverage.Left::areaM2)),
                uncovered);
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
