package org.sami.crw.handler.boat;

import java.util.Set;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.EventNames;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/**
 * Set Gains: the gains of each boat's two control loops. What the fleet's plans call rudder is the loop that steers; thrust is the
 * loop that drives.
 */
public final class SetGainsHandler implements ActivationHandler {
    public static final String TYPE = "SetGains";
    private static final SettingRequests.Answers ANSWERS =
            new SettingRequests.Answers(EventNames.GAINS_SUCCEEDED, EventNames.GAINS_FAILED);

    private final SettingRequests settings;

    public SetGainsHandler(SettingRequests settings) {
        this.settings = settings;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        settings.ask(activation, context, ANSWERS, boat -> {
            Gains steering = gains(activation, "rudder");
            Gains driving = gains(activation, "thrust");
            return Set.of(
                    boat.settings().setGains(GainAxis.HEADING, steering),
                    boat.settings().setGains(GainAxis.SPEED, driving));
        });
    }

    private static Gains gains(Activation activation, String loop) {
        return new Gains(
                ActivationFields.number(activation, loop + "P"),
                ActivationFields.number(activation, loop + "I"),
                ActivationFields.number(activation, loop + "D"));
    }
}
