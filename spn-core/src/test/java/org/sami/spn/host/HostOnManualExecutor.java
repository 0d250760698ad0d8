package org.sami.spn.host;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.protocol.Input;

/** A host with an executor and a clock that the test turns by hand. */
abstract class HostOnManualExecutor {
    final List<String> log = new ArrayList<>();
    final WatchedJournal journal = new WatchedJournal(log);
    final ManualExecutor executor = new ManualExecutor();
    final ManualClock clock = new ManualClock();
    final Engine engine = HostPlans.engine();
    final EngineState state = engine.newState();
    final EngineHost host = builder().build();

    EngineHostBuilder builder() {
        return EngineHostBuilder.of(engine, state).journal(journal).clock(clock).executor(executor);
    }

    List<Input> inputs() {
        return journal.entries().stream().map(JournalEntry::input).toList();
    }
}
