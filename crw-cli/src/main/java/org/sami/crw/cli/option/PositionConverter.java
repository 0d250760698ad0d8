package org.sami.crw.cli.option;

import java.util.OptionalDouble;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TextNumbers;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads a WGS 84 position, latitude and longitude in degrees with a comma between. */
public final class PositionConverter implements ITypeConverter<GeoPoint> {
    private static final double MOST_LAT_DEG = 85; // hulls move on a plane, which the poles do not have

    @Override
    public GeoPoint convert(String text) {
        String[] parts = text.split(",", -1);
        if (parts.length == 2) {
            OptionalDouble latDeg = TextNumbers.real(parts[0], -MOST_LAT_DEG, MOST_LAT_DEG);
            OptionalDouble lonDeg = TextNumbers.real(parts[1], -180, 180);
            if (latDeg.isPresent() && lonDeg.isPresent()) {
                return GeoPoint.of(latDeg.getAsDouble(), lonDeg.getAsDouble());
            }
        }
        throw new TypeConversionException(
                "expected is LAT,LON in degrees, at most 85 and 180, such as 45.4,10.9, not '" + text + "'");
    }
}
