package org.sami.crw.handler.motion;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyCommands;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Token;

/** Which missions a boat aborts (appendix .2.1, Abort). */
public enum AbortScope {
    /** Send Abort Mission: the one that asks. */
    THIS("SendAbortMission"),
    /** Send Proxy Abort All Missions: every one that has a command for the boat, or is to have one, or in which it stands. */
    ALL("SendProxyAbortAllMissions"),
    /** Send Proxy Abort Future Missions: every one whose commands wait in the boat's queue, or for it, but for the one it carries out. */
    FUTURE("SendProxyAbortFutureMissions");

    private final String type;

    AbortScope(String type) {
        this.type = type;
    }

    public String type() {
        return type;
    }

    /**
     * The missions that a boat aborts, each once.
     *
     * @param aborts knows those that have something for the boat that is not in its queue yet
     */
    Set<Long> missions(
            String boat, Optional<BoatProxy> proxy, Aborts aborts, Activation activation, HandlerContext context) {
        Set<Long> missions = new LinkedHashSet<>();
        if (this == THIS) {
            missions.add(activation.mission());
            return missions;
        }
        Optional<ProxyCommands> commands = proxy.map(BoatProxy::commands);
        commands.map(ProxyCommands::waiting).orElse(List.of()).stream()
                .filter(command -> !ChargeReturns.isOne(command)) // no mission's
                .forEach(command -> missions.add(command.mission()));
        missions.addAll(aborts.waiting(boat));
        if (this == FUTURE) {
            missions.removeAll(aborts.begun(boat));
        } else {
            missions.addAll(aborts.begun(boat));
            missions.addAll(whereItStands(boat, context));
        }
        return missions;
    }

    private static List<Long> whereItStands(String boat, HandlerContext context) {
        return context.query(view -> view.missions().stream()
                .filter(mission ->
                        mission.marking().values().stream().anyMatch(tokens -> tokens.contains(new Token.Proxy(boat))))
                .map(mission -> mission.id())
                .toList());
    }
}
