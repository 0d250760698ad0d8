package org.sami.crw.handler.boat;

import java.util.Set;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.EventNames;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/** Set Velocity Multiplier: scales the speed at which each boat follows its paths, those under way too (field plans, 8.1). */
public final class VelocityMultiplierHandler implements ActivationHandler {
    public static final String TYPE = "SetVelocityMultiplier";
    private static final SettingRequests.Answers ANSWERS =
            new SettingRequests.Answers(EventNames.MULTIPLIER_SUCCEEDED, EventNames.MULTIPLIER_FAILED);

    private final SettingRequests settings;

    public VelocityMultiplierHandler(SettingRequests settings) {
        this.settings = settings;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        double multiplier = ActivationFields.number(activation, "multiplier");
        settings.ask(
                activation, context, ANSWERS, boat -> Set.of(boat.settings().setVelocityMultiplier(multiplier)));
    }
}
