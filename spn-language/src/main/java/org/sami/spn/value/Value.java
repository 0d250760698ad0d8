package org.sami.spn.value;

/**
 * A typed, immutable value: what a field of an event, a variable or an option of a markup holds. Equality is by value;
 * real numbers compare by {@link Double#equals}.
 */
public sealed interface Value
        permits BooleanValue,
                IntegerValue,
                RealValue,
                TextValue,
                DurationValue,
                EnumValue,
                RecordValue,
                ListValue,
                MapValue,
                ProxyValue,
                TaskId,
                GeoPoint,
                GeoPath,
                GeoArea,
                VariableReference,
                PlanReference {}
