package org.sami.session.server;

import java.util.HashMap;
import java.util.Map;
import java.util.function.LongSupplier;

/** How many wrong names and keys each address may try. For one thread. */
final class FailedLogins {
    private static final double PER_SECOND = 5 / 60.0;
    private static final int AT_ONCE = 5;
    private static final int MOST_ADDRESSES = 1000;

    private final LongSupplier nanos;
    private final Map<String, MessageAllowance> addresses = new HashMap<>();

    FailedLogins(LongSupplier nanos) {
        this.nanos = nanos;
    }

    /** Notes one; gives why it is refused, in words. */
    String refusal(String address) {
        addresses.values().removeIf(MessageAllowance::isFull);
        if (addresses.size() < MOST_ADDRESSES) {
            MessageAllowance allowance =
                    addresses.computeIfAbsent(address, made -> new MessageAllowance(PER_SECOND, AT_ONCE, nanos));
            if (!allowance.allows()) {
                return "too many wrong names or keys from " + address + "; wait a minute";
            }
        }
        return "no such name and key";
    }
}
