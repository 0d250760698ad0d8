package org.sami.crw.sim.run.record;

import java.util.List;
import org.sami.crw.operator.ClickCount;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** The operator's clicks. */
final class ClickFold implements ReportFold {
    private final ClickCount count = new ClickCount();

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        count.count(input, effects);
    }

    @Override
    public void addTo(ReportDraft report) {
        report.clicks(count.clicks());
    }
}
