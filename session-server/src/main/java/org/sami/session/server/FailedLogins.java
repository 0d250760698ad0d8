package org.sami.session.server;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
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

    /** Why an address may not try now, in words; empty where it may. To look a key up takes some 0.1 s, so this is asked before. */
    Optional<String> refusal(String address) {
        MessageAllowance allowance = addresses.get(address);
        return allowance == null || allowance.hasLeft()
                ? Optional.empty()
                : Optional.of("too many wrong names or keys from " + address + "; wait a minute");
    }

    /** Notes a wrong name or key. */
    void note(String address) {
        addresses.values().removeIf(MessageAllowance::isFull);
        if (addresses.size() < MOST_ADDRESSES || addresses.containsKey(address)) {
            addresses
                    .computeIfAbsent(address, made -> new MessageAllowance(PER_SECOND, AT_ONCE, nanos))
                    .allows();
        }
    }
}
