package org.sami.crw.handler;

import java.util.List;
import java.util.ServiceLoader;
import org.sami.crw.fleet.RobotKind;

/** The {@link HandlerModule}s that are on the class path. */
public final class HandlerModules {
    private static final List<HandlerModule> ALL = ServiceLoader.load(HandlerModule.class).stream()
            .map(ServiceLoader.Provider::get)
            .toList();

    private HandlerModules() {}

    /** Those of a domain. */
    static List<HandlerModule> of(String domain) {
        return ALL.stream().filter(module -> module.domain().equals(domain)).toList();
    }

    /** What a domain's plans command; boats where no module says otherwise. */
    public static RobotKind robotsOf(String domain) {
        return of(domain).stream().map(HandlerModule::robots).findFirst().orElse(RobotKind.BOAT);
    }

    /** Whether output events of a domain have handlers on this class path: those of the boats always. */
    public static boolean isHandled(String domain) {
        return domain.equals("crw") || !of(domain).isEmpty();
    }
}
