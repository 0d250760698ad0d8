package org.sami.crw.cli.option;

import java.util.Locale;
import org.sami.crw.sim.hull.NamedConditions;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads conditions by their names. */
public final class ConditionsConverter implements ITypeConverter<NamedConditions> {
    @Override
    public NamedConditions convert(String name) {
        return NamedConditions.named(name.toLowerCase(Locale.ROOT))
                .orElseThrow(() ->
                        new TypeConversionException("expected is calm, field, rough or logged, not '" + name + "'"));
    }
}
