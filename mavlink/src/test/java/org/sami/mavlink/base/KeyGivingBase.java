package org.sami.mavlink.base;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.link.LinkSigning;
import org.sami.mavlink.link.SigningKey;
import org.sami.mavlink.testing.SmallBoat;

/** A base that can give vehicles a key, linked to one boat that has none. */
final class KeyGivingBase {
    private static final byte[] SECRET = new byte[SigningKey.BYTES];

    static {
        SECRET[0] = 1; // none of zeros alone is a key
    }

    private KeyGivingBase() {}

    static MavlinkBase linked(SmallBoat boat, LongSupplier clock) {
        LinkSigning signing = new LinkSigning(new SigningKey(SECRET), Instant::now, LinkSigning.Unsigned.TAKEN);
        return new MavlinkBase(
                List.of(AddressText.parse(boat.address())),
                clock,
                new MavlinkBaseOptions(Optional.empty(), Optional.of(signing)));
    }
}
