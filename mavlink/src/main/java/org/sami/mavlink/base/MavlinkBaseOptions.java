package org.sami.mavlink.base;

import java.security.SecureRandom;
import java.util.Objects;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.sami.mavlink.link.LinkSigning;
import org.sami.mavlink.param.ParameterFiles;

/**
 * What a base does beyond listening and commanding.
 *
 * @param parameters where the parameters that were read are kept for people; empty where they are not. Nothing here goes by them
 * @param signing how messages are signed, and which are refused; empty where none are signed and all are taken
 * @param marks gives each base the number by which it knows its own heartbeats
 */
public record MavlinkBaseOptions(
        Optional<ParameterFiles> parameters, Optional<LinkSigning> signing, RandomGenerator marks) {
    /** Options. */
    public MavlinkBaseOptions {
        Objects.requireNonNull(parameters, "parameters");
        Objects.requireNonNull(signing, "signing");
        Objects.requireNonNull(marks, "marks");
    }

    /** The same with a mark that nobody foresees. */
    public MavlinkBaseOptions(Optional<ParameterFiles> parameters, Optional<LinkSigning> signing) {
        this(parameters, signing, new SecureRandom());
    }

    /** A base that keeps nothing and signs nothing. */
    public static MavlinkBaseOptions none() {
        return new MavlinkBaseOptions(Optional.empty(), Optional.empty());
    }
}
