package org.sami.crw.sim.experiment;

import java.util.Iterator;
import java.util.List;
import java.util.OptionalDouble;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.file.CsvRow;

/** A row as text with every digit of its numbers, and back: another machine prints the same table of it. */
final class ExperimentRowText {
    private static final int CELLS = 22;

    private ExperimentRowText() {}

    static String write(ExperimentRow row) {
        return CsvRow.of(
                row.run().label(),
                row.run().conditions(),
                row.run().seed(),
                row.ending().outcome().name(),
                row.ending().reason(),
                row.ending().problems(),
                row.ending().simulatedMillis(),
                row.ending().hash(),
                row.visits().locations(),
                row.visits().reported(),
                row.visits().visited(),
                cell(row.visits().farthestM()),
                row.coverage().areaM2(),
                cell(row.coverage().plannedUncoveredM2()),
                row.coverage().uncoveredM2(),
                cell(row.distances().insideM()),
                cell(row.distances().announcedM()),
                cell(row.distances().closestM()),
                cell(row.distances().underWayM()),
                row.distances().nearMillis(),
                row.emptyBoats(),
                row.targets());
    }

    private static String cell(OptionalDouble value) {
        return value.isEmpty() ? "" : Double.toString(value.getAsDouble());
    }

    /**
     * Reads what {@link #write} wrote.
     *
     * @throws IllegalArgumentException where it is something else
     */
    static ExperimentRow read(String text) {
        List<String> cells = CsvRow.cells(text.stripTrailing());
        if (cells.size() != CELLS) {
            throw new IllegalArgumentException("this is no row of a run: " + text);
        }
        Iterator<String> next = cells.iterator();
        ExperimentRow.Run run = new ExperimentRow.Run(next.next(), next.next(), Long.parseLong(next.next()));
        ExperimentRow.Ending ending = new ExperimentRow.Ending(
                RunOutcome.valueOf(next.next()),
                next.next(),
                Integer.parseInt(next.next()),
                Long.parseLong(next.next()),
                next.next());
        ExperimentRow.Visits visits = new ExperimentRow.Visits(
                Integer.parseInt(next.next()),
                Integer.parseInt(next.next()),
                Integer.parseInt(next.next()),
                number(next.next()));
        ExperimentRow.Coverage coverage = new ExperimentRow.Coverage(
                Double.parseDouble(next.next()), number(next.next()), Double.parseDouble(next.next()));
        OptionalDouble inside = number(next.next());
        OptionalDouble announced = number(next.next());
        OptionalDouble closest = number(next.next());
        OptionalDouble underWay = number(next.next());
        long nearMillis = Long.parseLong(next.next());
        return new ExperimentRow(
                run,
                ending,
                visits,
                coverage,
                new ExperimentRow.Distances(inside, announced, closest, underWay, nearMillis),
                Integer.parseInt(next.next()),
                Integer.parseInt(next.next()));
    }

    private static OptionalDouble number(String cell) {
        return cell.isEmpty() ? OptionalDouble.empty() : OptionalDouble.of(Double.parseDouble(cell));
    }
}
