package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;

/**
 * Send Abort Mission, Send Proxy Abort All Missions, Send Proxy Abort Future Missions: each entering boat drops the commands of the missions in
 * scope, and signals Proxy Abort Mission Received to each of them. Missions other than the asking one then receive the failure that they wait for.
 */
public final class AbortHandler implements ActivationHandler {
    private final AbortScope scope;
    private final ProxyRegistry boats;
    private final Aborts aborts;

    public AbortHandler(AbortScope scope, ProxyRegistry boats, Aborts aborts) {
        this.scope = scope;
        this.boats = boats;
        this.aborts = aborts;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<Input> signals = new ArrayList<>();
        List<Runnable> withdrawals = new ArrayList<>();
        for (Addressee addressee : Addressee.of(activation, context)) {
            String boat = addressee.boat();
            for (long mission : scope.missions(boat, boats.find(boat), aborts, activation, context)) {
                boolean own = mission == activation.mission();
                signals.add(new Input.Received(
                        own
                                ? addressee.answer(EventNames.PROXY_ABORTED, activation, Map.of())
                                : new Occurrence(
                                        EventNames.PROXY_ABORTED,
                                        mission,
                                        Ids.NONE,
                                        List.of(boat),
                                        List.of(),
                                        Map.of())));
                withdrawals.add(
                        own
                                ? () -> aborts.withdraw(mission, boat)
                                : () -> aborts.abort(
                                        mission,
                                        boat,
                                        "mission " + activation.mission() + " made " + boat + " abort it"));
            }
        }
        if (!signals.isEmpty()) {
            context.post(signals);
        }
        withdrawals.forEach(Runnable::run);
    }
}
