package org.sami.crw.sim.experiment.table;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import org.sami.crw.report.file.CsvRow;
import org.sami.crw.sim.experiment.Portions;

/** The repetitions of a table: each is a portion, as its versions share their incidents. */
final class RepetitionPortions implements Portions<RunRow> {
    private static final char END = '\u001e'; // of a row: reasons may have line feeds

    private final List<Repetition> repetitions;
    private final List<Integer> order;

    /**
     * Portions of repetitions.
     *
     * @param repetitions in the order of rows
     * @param order indices of repetitions in the order in which they are begun
     */
    RepetitionPortions(List<Repetition> repetitions, List<Integer> order) {
        this.repetitions = List.copyOf(repetitions);
        this.order = List.copyOf(order);
    }

    @Override
    public int count() {
        return order.size();
    }

    @Override
    public Optional<String> make(int portion, BooleanSupplier stop) {
        return repetitions
                .get(order.get(portion))
                .run(stop)
                .map(rows -> rows.stream().map(row -> row.exact() + END).collect(Collectors.joining()));
    }

    @Override
    public List<RunRow> rows(Map<Integer, String> results, Map<Integer, String> givenUp) {
        List<List<RunRow>> rows = new ArrayList<>(Collections.nCopies(repetitions.size(), List.of()));
        givenUp.forEach((portion, reason) ->
                rows.set(order.get(portion), repetitions.get(order.get(portion)).failed(reason)));
        results.forEach((portion, text) -> rows.set(order.get(portion), read(text)));
        return rows.stream().flatMap(List::stream).toList();
    }

    private static List<RunRow> read(String text) {
        List<RunRow> rows = new ArrayList<>();
        int from = 0;
        for (int end = text.indexOf(END); end >= 0; end = text.indexOf(END, from)) {
            String row = text.substring(from, end - 1); // without its line feed
            rows.add(RunRow.read(CsvRow.cells(row))
                    .orElseThrow(() -> new IllegalArgumentException("this is no row of a run: " + row)));
            from = end + 1;
        }
        return rows;
    }
}
