package org.sami.crw.cli.option;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.journal.postgres.PostgresAddress;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The option {@code --workers}: where the runs of an experiment stand that several machines divide. */
public final class WorkersOption {
    @Option(
            names = "--workers",
            paramLabel = "ADDRESS",
            converter = Converter.class,
            description =
                    "Divide the runs with all machines on which the same command runs. They stand in PostgreSQL, at"
                            + " postgresql://HOST/DATABASE?user=NAME&schema=NAME (docs/scale.md).")
    private @Nullable PostgresAddress address;

    /** Reads an address of PostgreSQL. */
    static final class Converter implements ITypeConverter<PostgresAddress> {
        @Override
        public PostgresAddress convert(String text) {
            try {
                return PostgresAddress.parse(text);
            } catch (IllegalArgumentException unfit) {
                throw new TypeConversionException(unfit.getMessage());
            }
        }
    }

    /** The address; empty where this machine makes all runs. */
    public Optional<PostgresAddress> address() {
        return Optional.ofNullable(address);
    }
}
