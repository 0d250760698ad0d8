package org.sami.crw.sim.run.record;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.sami.crw.report.statistics.SessionFigures;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.engine.Engine;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalPlans;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.Telemetry;
import org.sami.spn.vocabulary.Vocabulary;

/** The figures of the session that a journal is of. The journal is only read, also while a session writes it. */
public final class JournalStatistics {
    private JournalStatistics() {}

    /**
     * Reads a journal.
     *
     * @throws IOException with a sentence that names the journal, if it is no journal, or this program cannot read its plans
     */
    public static SessionFigures of(JournalAddress file) throws IOException {
        try (JournalReader reader = file.read()) {
            Vocabulary vocabulary = JournalPlans.vocabulary(file, reader.header());
            Engine engine = new Engine(vocabulary, JournalPlans.project(file, reader.header(), vocabulary));
            Telemetry telemetry = reader.telemetry();
            Odometers odometers = new Odometers();
            int senseless = SessionTelemetry.read(telemetry.rows(), odometers).size();
            MissionFiguresFold fold = new MissionFiguresFold(vocabulary, odometers);
            long[] firstMillis = {-1};
            reader.replay(engine, 1, reader.lastIndex(), (index, at, input, effects, view) -> {
                firstMillis[0] = firstMillis[0] < 0 ? at : firstMillis[0];
                fold.onStep(index, at, input, effects, view);
            });
            List<String> remarks = new ArrayList<>();
            reader.recovery().damage().ifPresent(remarks::add);
            telemetry.damage().ifPresent(remarks::add);
            if (senseless > 0) {
                remarks.add(file + ": rows of telemetry that make no sense are left out: " + senseless);
            }
            return new SessionFigures(
                    1,
                    reader.lastMillis() - Math.max(0, firstMillis[0]),
                    fold.clicks(),
                    fold.decisions(),
                    fold.missions(reader.lastMillis()),
                    remarks);
        }
    }
}
