package org.sami.crw.handler;

import java.util.Set;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/** Set Velocity Multiplier: scales the speed at which each boat follows its paths, those under way too (field plans, 8.1). */
final class VelocityMultiplierHandler implements ActivationHandler {
    static final String TYPE = "SetVelocityMultiplier";
    private static final BoatSettings.Answers ANSWERS =
            new BoatSettings.Answers(EventNames.MULTIPLIER_SUCCEEDED, EventNames.MULTIPLIER_FAILED);

    private final BoatSettings settings;

    VelocityMultiplierHandler(BoatSettings settings) {
        this.settings = settings;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        double multiplier = ActivationFields.number(activation, "multiplier");
        settings.ask(activation, context, ANSWERS, boat -> Set.of(boat.setVelocityMultiplier(multiplier)));
    }
}
