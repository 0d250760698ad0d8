package org.sami.crw.cli.vehicle;

import java.util.Locale;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.base.AskedMessage;
import org.sami.mavlink.base.MessagePlan;

/** What vehicles on a link are asked to send, and what it costs, as a table. */
final class BudgetText {
    private static final int PERCENT = 100;

    private BudgetText() {}

    static String of(MavlinkAddress link, MessagePlan plan) {
        StringBuilder text = new StringBuilder(
                format("%s: %d vehicle%s, each asked for:%n", link, plan.vehicles(), plan.vehicles() == 1 ? "" : "s"));
        for (AskedMessage message : plan.messages()) {
            text.append(format(
                    "  %-20s every %6.2f s  %6.1f bytes/s%n",
                    message.name(), message.everyS(), message.bytesPerSecond(plan.signed())));
        }
        text.append(format("  %.0f bytes/s each with its heartbeat", plan.bytesPerVehicle()));
        plan.filledPart()
                .ifPresent(part -> text.append(format(
                        ", %.0f of %.0f bytes/s together: %.0f %% of the link%s",
                        plan.vehicles() * plan.bytesPerVehicle(),
                        plan.bytesPerSecond().orElse(0),
                        part * PERCENT,
                        part > 1 ? ", too many vehicles for it" : "")));
        return text.append(format("%n")).toString();
    }

    private static String format(String form, Object... values) {
        return String.format(Locale.ROOT, form, values);
    }
}
