package org.sami.crw.handler;

import java.util.List;
import java.util.Set;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.engine.Engine;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostClock;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** Which output events the domain has handlers for, asked of the domain itself. */
public final class HandledEvents {
    /** Nothing runs on it. */
    private static final HostClock NO_TIME = new HostClock() {
        @Override
        public long nowMillis() {
            return 0;
        }

        @Override
        public void wakeAt(long millis, Runnable action) {
            // nothing is ever due: no input is posted
        }
    };

    private HandledEvents() {}

    /** The names of the output events that a run's handlers do; decisions and the engine's own events are not among them. */
    public static Set<String> of(Vocabulary vocabulary) {
        Engine engine =
                new Engine(vocabulary, new Project("none", "", vocabulary.domain(), List.of(), List.of(), List.of()));
        try (EngineHost host = EngineHostBuilder.of(engine, engine.newState())
                        .executor(Runnable::run)
                        .clock(NO_TIME)
                        .build();
                CrwDomain domain = CrwDomain.install(host, new ProxyRegistry(), Runnable::run, message -> {})) {
            return domain.handledTypes();
        }
    }
}
