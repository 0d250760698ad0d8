package org.sami.mavlink.base;

import java.util.Optional;
import org.sami.mavlink.link.LinkSigning;
import org.sami.mavlink.param.ParameterFiles;

/**
 * What a base does beyond listening and commanding.
 *
 * @param parameters where the parameters of vehicles are kept; empty where they are read from each vehicle each time
 * @param signing how messages are signed, and which are refused; empty where none are signed and all are taken
 */
public record MavlinkBaseOptions(Optional<ParameterFiles> parameters, Optional<LinkSigning> signing) {
    /** A base that keeps nothing and signs nothing. */
    public static MavlinkBaseOptions none() {
        return new MavlinkBaseOptions(Optional.empty(), Optional.empty());
    }
}
