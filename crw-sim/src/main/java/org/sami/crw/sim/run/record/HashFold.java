package org.sami.crw.sim.run.record;

import java.util.List;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** The run's hash. */
final class HashFold implements ReportFold {
    private final RunHash hash = new RunHash();

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        hash.add(atMillis, effects);
    }

    @Override
    public void addTo(ReportDraft report) {
        report.hash(hash.with(report.end().boats()));
    }
}
