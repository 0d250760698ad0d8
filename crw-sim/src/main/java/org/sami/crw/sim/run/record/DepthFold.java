package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.report.DepthsPart;
import org.sami.crw.report.DepthsPart.DepthCell;
import org.sami.crw.report.DepthsPart.MapError;
import org.sami.crw.sim.layer.DepthGrid;
import org.sami.crw.sim.layer.Sonar;
import org.sami.session.record.SensorValue;

/**
 * Maps the depth that boats measure, at the places where they take themselves to be; real boats' sonars, too. Nothing where nobody measured. Safe for use by
 * several threads.
 */
public final class DepthFold implements ReportFold {
    private final LocalFrame plane;
    private final DepthSquares squares = new DepthSquares();
    private Optional<DepthGrid> truth = Optional.empty();

    DepthFold(LocalFrame plane) {
        this.plane = plane;
    }

    /** The map is compared with the true depths. */
    public synchronized void compareWith(DepthGrid trueDepths) {
        truth = Optional.of(trueDepths);
    }

    @Override
    public synchronized void onReading(SensorValue reading) {
        if (reading.sensor().startsWith(Sonar.INSTRUMENT)
                && reading.channel().equals(Sonar.CHANNEL)
                && !reading.values().isEmpty()) {
            squares.add(
                    plane.eastM(reading.position().latDeg(), reading.position().lonDeg()),
                    plane.northM(reading.position().latDeg(), reading.position().lonDeg()),
                    reading.values().get(0));
        }
    }

    @Override
    public synchronized void addTo(ReportDraft report) {
        List<DepthCell> cells = squares.cells(plane);
        if (!cells.isEmpty()) {
            report.add(new DepthsPart(
                    DepthSquares.SIDE_M, squares.readings(), cells, truth.flatMap(depths -> error(cells, depths))));
        }
    }

    private static Optional<MapError> error(List<DepthCell> cells, DepthGrid depths) {
        List<Double> off = new ArrayList<>();
        for (DepthCell cell : cells) {
            OptionalDouble trueM =
                    depths.depthM(cell.middle().latDeg(), cell.middle().lonDeg());
            trueM.ifPresent(depthM -> off.add(Math.abs(depthM - cell.depthM())));
        }
        if (off.isEmpty()) {
            return Optional.empty();
        }
        List<Double> sorted = off.stream().sorted().toList();
        return Optional.of(new MapError(
                sorted.size(),
                sorted.stream().mapToDouble(Double::doubleValue).average().orElseThrow(),
                sorted.get((int) Math.ceil(0.95 * sorted.size()) - 1)));
    }
}
