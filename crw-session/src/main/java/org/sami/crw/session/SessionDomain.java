package org.sami.crw.session;

import java.io.Closeable;
import java.util.Optional;
import org.sami.crw.handler.CrwDomain;
import org.sami.crw.handler.planning.ServiceThreads;
import org.sami.crw.message.MessageSink;
import org.sami.crw.session.fault.ThreadGuard;

/** The handlers of a session's plans, and in real time the threads on which services compute. */
final class SessionDomain implements Closeable {
    private final Optional<ServiceThreads> services;
    private final CrwDomain domain;

    /** Puts the handlers on the engine's host. */
    SessionDomain(
            SessionSetup setup,
            SessionThreads threads,
            SessionEngine engine,
            SessionFleet fleet,
            MessageSink messages,
            ThreadGuard guard) {
        FleetConnector connector = fleet.connector();
        services = threads.isRealTime()
                ? Optional.of(new ServiceThreads(ServiceThreads.STANDARD_LIMIT_MILLIS, guard::lost))
                : Optional.empty();
        domain = services.map(own -> CrwDomain.installInRealTime(
                        engine.host(),
                        connector.boats(),
                        connector.executor(),
                        messages,
                        setup.services(),
                        connector,
                        fleet.events(),
                        own))
                .orElseGet(() -> CrwDomain.install(
                        engine.host(),
                        connector.boats(),
                        connector.executor(),
                        messages,
                        setup.services(),
                        connector,
                        fleet.events()));
    }

    CrwDomain handlers() {
        return domain;
    }

    @Override
    public void close() {
        services.ifPresent(ServiceThreads::close);
    }
}
